// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/correct_rounding.py
// atan(i / 32) and atan(i / 2048) in units of 2^-64 and, beyond them, of 2^-96; sine and cosine of i / 64 in units of 2^-64, 1 as a unit less;
// and the 64 leading bits of e^i from i = 9 on, the lower half first.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct CorrectRoundingTable {
    static constexpr uint64_t coarse[33] FIXEDPOINT_PROGRAM_MEMORY = {
        0x0000000000000000ull, 0x07ff556eea5d892aull, 0x0ffaaddb967ef4e3ull, 0x17ee182602f10e8cull,
        0x1fd5ba9aac2f6dc6ull, 0x27adddd18cc4d8b0ull, 0x2f72f6979cb6044dull, 0x3721aea524c14408ull,
        0x3eb6ebf25901bac5ull, 0x462fd68c2fc5e098ull, 0x4d89dcdc1faf2f34ull, 0x54c2b6654735276dull,
        0x5bd86507937bc239ull, 0x62c934e5286c95b6ull, 0x6993bb0f308ff2dbull, 0x7036d3253b27be33ull,
        0x76b19c1586ed3da2ull, 0x7d03742d50505f2eull, 0x832bf4a6d9867e2aull, 0x892aecdfde9547b5ull,
        0x8f005d5ef7f59f9bull, 0x94ac72c9847186f6ull, 0x9a2f80e671bdda20ull, 0x9f89fdc4f4b7a1ecull,
        0xa4bc7d1934f70924ull, 0xa9c7abdc4830f5c8ull, 0xaeac4c38b4d8c080ull, 0xb36b31c91f043691ull,
        0xb8053e2bc2319e73ull, 0xbc7b5deae98af280ull, 0xc0ce85b8ac526640ull, 0xc4ffaffabf8fbd54ull,
        0xc90fdaa22168c234ull};
    static constexpr uint32_t coarse_below[33] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000u, 0x13bcebbbu, 0x6cb2792eu, 0x126acfcfu, 0x5912f314u, 0xd1d86749u, 0x1ec2d3e2u, 0xbd886970u,
        0x5b71e7bdu, 0x6523a459u, 0xe2d5da4cu, 0x4cdbfbbeu, 0xc5519091u, 0xd0ba3749u, 0x213e4af5u, 0xe318f6cbu,
        0xb7f222f6u, 0x33691e3fu, 0x4b6a09cbu, 0x094478fcu, 0x5c835e16u, 0x18c4f394u, 0x4226f8e2u, 0xf8b49264u,
        0x19a87f2au, 0x916a84b6u, 0x14725e2fu, 0x59014174u, 0xcb2da552u, 0xd4113007u, 0x89dd62c4u, 0x8cb43d11u,
        0xc4c6628cu};
    static constexpr uint64_t fine[69] FIXEDPOINT_PROGRAM_MEMORY = {
        0x0000000000000000ull, 0x001fffffd55555bbull, 0x003ffffeaaaab777ull, 0x005ffffb80006133ull,
        0x007ffff55556eeeeull, 0x009fffeb2aaf8ca9ull, 0x00bfffdc000c2661ull, 0x00dfffc6d56f9813ull,
        0x00ffffaaaaddddb9ull, 0x011fff86805c4346ull, 0x013fff5955f194a6ull, 0x015fff222ba64dbdull,
        0x017ffee00184ca5bull, 0x019ffe91d7997642ull, 0x01bffe36adf2fd16ull, 0x01dffdcd84a27a5cull,
        0x01fffd555bbba972ull, 0x021ffccd33551584ull, 0x023ffc340b88497full, 0x025ffb88e472000cull,
        0x027ffacabe32537aull, 0x029ff9f898ecedb8ull, 0x02bff91174c9383bull, 0x02dff81451f28bf4ull,
        0x02fff70030986134ull, 0x031ff5d410ee7f9cull, 0x033ff48ef32d2e02ull, 0x035ff32fd7916257ull,
        0x037ff1b5be5cf188ull, 0x039ff01fa7d6bf65ull, 0x03bfee6c944aee79ull, 0x03dfec9b840b0febull,
        0x03ffeaab776e5356ull, 0x041fe89b6ed1b6a2ull, 0x043fe66a6a9835d4ull, 0x045fe4176b2afae5ull,
        0x047fe1a170f98d8cull, 0x049fdf077c7a030dull, 0x04bfdc488e292e02ull, 0x04dfd963a68ace1dull,
        0x04ffd657c629bfedull, 0x051fd323ed982c9eull, 0x053fcfc71d6fb9b0ull, 0x055fcc405651b8b4ull,
        0x057fc88e98e756ffull, 0x059fc4b0e5e1cd57ull, 0x05bfc0a63dfa8fa7ull, 0x05dfbc6da1f37ca2ull,
        0x05ffb80612970d6bull, 0x061fb36e90b88536ull, 0x063faea61d3420e4ull, 0x065fa9abb8ef469eull,
        0x067fa47e64d8b567ull, 0x069f9f1d21e8b4aeull, 0x06bf9986f12143d9ull, 0x06df93bad38e49cdull,
        0x06ff8db7ca45c470ull, 0x071f877cd667f828ull, 0x073f8108f91f9f4full, 0x075f7a5b33a219b1ull,
        0x077f7372872f9bf1ull, 0x079f6c4df5135efaull, 0x07bf64ec7ea3cf61ull, 0x07df5d4d2542bcc4ull,
        0x07ff556eea5d892aull, 0x081f4d50cf6d584eull, 0x083f44f1d5f73efaull, 0x085f3c50ff8c7249ull,
        0x087f336d4dca76eeull};
    static constexpr uint32_t fine_below[69] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000u, 0xbbba9729u, 0x76e52e5au, 0x296fc68eu, 0xa5ca6adfu, 0x4de55dc6u, 0x84b1adb8u, 0xc5a2af70u,
        0x4bb12afbu, 0x31616b08u, 0xf34dd408u, 0x3eb8329cu, 0xf5a48e14u, 0x5200fd0du, 0x115ebef0u, 0x92c1b59fu,
        0xd00c46a4u, 0x1c8eab21u, 0x9241c90bu, 0x1736d75fu, 0xe4c649c0u, 0x7a09ce1du, 0xe32e892du, 0x3f2e33e6u,
        0x6d7f457cu, 0xcd4df206u, 0xf7d17681u, 0x5f52eea4u, 0xbc7cc8adu, 0x338bd641u, 0x1afcf83bu, 0x4d547554u,
        0xef9e3159u, 0x964833d8u, 0xb1fb39d2u, 0x2e176e5fu, 0x2a7dd9a8u, 0xba519d0eu, 0x915ead9du, 0x89d66c48u,
        0xec153c93u, 0x62270f7cu, 0x80c3c078u, 0xcf7f1e25u, 0x39eb873fu, 0xd37126c9u, 0xd79f0ffau, 0xd0bec381u,
        0xce7603f6u, 0x96464ec8u, 0xb7bcd1e4u, 0x6e294c2bu, 0x39b5f02au, 0x19be1cecu, 0x5245904au, 0xa67598f8u,
        0xf209c455u, 0x0b998d18u, 0xd9b0abfdu, 0x84abdac5u, 0xaf541befu, 0xa036eefeu, 0x45be4112u, 0xff0f64f2u,
        0x13bcebbbu, 0xc45bd863u, 0xde115c42u, 0xbb331198u, 0x9b1882b1u};
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
constexpr uint64_t CorrectRoundingTable<Any>::coarse[];
template <class Any>
constexpr uint32_t CorrectRoundingTable<Any>::coarse_below[];
template <class Any>
constexpr uint64_t CorrectRoundingTable<Any>::fine[];
template <class Any>
constexpr uint32_t CorrectRoundingTable<Any>::fine_below[];
template <class Any>
constexpr uint64_t CorrectRoundingTable<Any>::unit[];
template <class Any>
constexpr uint32_t CorrectRoundingTable<Any>::power[];

}  // namespace portable
}  // namespace fixedpoint
