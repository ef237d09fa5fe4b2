// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/correct_rounding.py
// Sine and cosine of i / 64 in units of 2^-64, 1 as a unit less;
// and the 64 leading bits of e^i from i = 9 on, the lower half first.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct CorrectRoundingTable {
    static constexpr uint64_t unit[102] FIXEDPOINT_PROGRAM_MEMORY = {
        0x0000000000000000ull, 0xffffffffffffffffull, 0x03fff5555dddda9eull, 0xfff8000aaaa4fa51ull,
        0x07ffaaabbbba1ba3ull, 0xffe000aaa93e9589ull, 0x0bfee008197dd455ull, 0xffb8035fefccf675ull,
        0x0ffd557776a76d5aull, 0xff800aaa4fa69a65ull, 0x13facb12d1755a9bull, 0xff381a094f7b771aull,
        0x17f701032550e41bull, 0xfee035fbf35cda63ull, 0x1bf1b78568391d7aull, 0xfe78640074cd88f5ull,
        0x1feaaeee86ee35caull, 0xfe00aa93eade9b6dull, 0x23e1a7af5f9d5d49ull, 0xfd791131e25e97abull,
        0x27d66258bacd96a4ull, 0xfce1a053e621438bull, 0x2bc89f9f424de548ull, 0xfc3a6170f767ac73ull,
        0x2fb8205f75e56a2bull, 0xfb835efcf670dd2dull, 0x33a4a5a19d862467ull, 0xfabca467fb3cb8f2ull,
        0x378df09db8c332ceull, 0xf9e63e1d9e8b6f6full, 0x3b73c2bf6b4b9f67ull, 0xf90039843324f9b9ull,
        0x3f55dda9e62aed75ull, 0xf80aa4fbef750ba8ull, 0x4334033bcd90d660ull, 0xf7058fde0788dfc8ull,
        0x470df5931ae1d946ull, 0xf5f10a7bb77d3dfaull, 0x4ae37710fad27c8bull, 0xf4cd261d3e6c15bbull,
        0x4eb44a5da74f6002ull, 0xf399f500c9e9fd38ull, 0x5280326c3cf48182ull, 0xf2578a595224dd2eull,
        0x5646f27e8bd65cbeull, 0xf105fa4d66b607a6ull, 0x5a084e28e35fda27ull, 0xefa559f5ec3aec3aull,
        0x5dc40955d9084f49ull, 0xee35bf5ccac89053ull, 0x6179e84a09a5258aull, 0xecb7417b8d4ee3ffull,
        0x6529afa7d51b1296ull, 0xeb29f839f201fd14ull, 0x68d3247314332797ull, 0xe98dfc6c6be031e6ull,
        0x6c760c14c8585a52ull, 0xe7e367d2956cfb17ull, 0x70122c5ec5028c8dull, 0xe62a551594b970a7ull,
        0x73a74b8f52947b68ull, 0xe462dfc670d421abull, 0x77353054ca72690dull, 0xe28d245c58baef72ull,
        0x7abba1d12c17bfa2ull, 0xe0a94032dbea7ceeull, 0x7e3a679daaf25c67ull, 0xdeb7518814a7a932ull,
        0x81b149ce34caa5a5ull, 0xdcb7777ac4207051ull, 0x852010f4f0800521ull, 0xdaa9d20860827064ull,
        0x88868625b4e1dbb2ull, 0xd88e820b1526311eull, 0x8be472f9776d809bull, 0xd665a937b4ef2b1full,
        0x8f39a191b2ba6123ull, 0xd42f6a1b9f0168ceull, 0x9285dc9bc45dd9eaull, 0xd1ebe81a95ee752eull,
        0x95c8ef544210ec0cull, 0xcf9b476c897c25c6ull, 0x9902a58a45e27bedull, 0xcd3dad1b5328a2e4ull,
        0x9c32cba2b14156efull, 0xcad33f00658fe5e8ull, 0x9f592e9b66a9cf90ull, 0xc85c23c26ed7b6f0ull,
        0xa2759c0e79c35582ull, 0xc5d882d2ee48030cull, 0xa587e23555bb0808ull, 0xc348846bbd363134ull,
        0xa88fcfebd9a8dd48ull, 0xc0ac518c8b6ae711ull, 0xab8d34b36acd9872ull, 0xbe0413f84f2a771cull,
        0xae7fe0b5fc786b2eull, 0xbb4ff632a908f73full, 0xb167a4c90d63c424ull, 0xb890237d3bb3c285ull,
        0xb44452709a597529ull, 0xb5c4c7d4f7dae916ull};
    static constexpr uint32_t power[48] FIXEDPOINT_PROGRAM_MEMORY = {
        0x387c0e1bu, 0xfd38abe2u, 0xa82afcf8u, 0xac14ee7cu, 0x727bf9f8u, 0xe9e22447u, 0x9be4d175u, 0x9ef0b2a6u,
        0x564aa9aau, 0xd805ac8bu, 0xf82eb77cu, 0x92cd6245u, 0x69543779u, 0xc786657du, 0x40010249u, 0x87975e85u,
        0x7527c674u, 0xb849a460u, 0xca05e985u, 0xfa791048u, 0x69370b94u, 0xaa36c7cfu, 0x47402011u, 0xe758445bu,
        0xf767eab3u, 0x9d370fecu, 0x21affc0eu, 0xd5ad6dceu, 0x8fee052cu, 0x9135799du, 0x3afdb99cu, 0xc55bfdaau,
        0x4b164455u, 0x861e9c90u, 0x535ae505u, 0xb649934bu, 0xb398e449u, 0xf7c117bfu, 0xb1bcd27eu, 0xa85dd1bcu,
        0x8e02b159u, 0xe4d57231u, 0x614764f4u, 0x9b823857u, 0x66fb66e0u, 0xd35bb2ecu, 0x5b3163ecu, 0x8fa1fe62u};
};
template <class Any>
constexpr uint64_t CorrectRoundingTable<Any>::unit[];
template <class Any>
constexpr uint32_t CorrectRoundingTable<Any>::power[];

}  // namespace portable
}  // namespace fixedpoint
