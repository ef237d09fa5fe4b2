// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/tangent_64.py
// The tangents of i / 256, in units of 2^-48.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct Tangent64Table {
    static constexpr uint64_t tangent[202] FIXEDPOINT_PROGRAM_MEMORY = {
        0x000000000000, 0x010000555577, 0x020002aaaeef, 0x030009002067,
        0x04001555dde1, 0x050029ac4b66, 0x060048040d08, 0x0700725e16f2,
        0x0800aabbbd76, 0x0900f31ec524, 0x0a014d8972e8, 0x0b01bbfe9c31,
        0x0c024081b722, 0x0d02dd16eacb, 0x0e0393c31f72, 0x0f04668c0ee6,
        0x1005577854df, 0x1106688f7f73, 0x12079bda1f92, 0x1308f361d99c,
        0x140a71317604, 0x150c1754f209, 0x160de7d99083, 0x170fe4cdeac6,
        0x18121042019d, 0x19146c474e5a, 0x1a16faf0d403, 0x1b19be53309a,
        0x1c1cb884ae7d, 0x1d1feb9d55e4, 0x1e2359b6fe84, 0x1f2704ed6144,
        0x202aef5e2a23, 0x212f1b290a32, 0x22338a6fc9b9, 0x23383f565a7f,
        0x243d3c02ea3b, 0x2542829df523, 0x2648155258b0, 0x274df64d6681,
        0x285427bef773, 0x295aabd97edf, 0x2a6184d21e0c, 0x2b68b4e0b7c7,
        0x2c703e40043a, 0x2d78232da4ed, 0x2e8065ea38fc, 0x2f8908b97185,
        0x30920de2264b, 0x319b77ae6a97, 0x32a5486ba250, 0x33af826a974e,
        0x34ba27ff8eee, 0x35c53b825fe7, 0x36d0bf4e885c, 0x37dcb5c34436,
        0x38e92143a3c2, 0x39f60436a294, 0x3b0361073eb5, 0x3c113a24901a,
        0x3d1f9201e06f, 0x3e2e6b16c323, 0x3f3dc7df2dd5, 0x404daadb9108,
        0x415e1690f131, 0x426f0d89001e, 0x4380925236b2, 0x4492a77fef02,
        0x45a54faa7ec9, 0x46b88d6f5248, 0x47cc6371077c, 0x48e0d45789c0,
        0x49f5e2d02ddc, 0x4b0b918dce71, 0x4c21e348e8de, 0x4d38dabfba92,
        0x4e507ab65ecd, 0x4f68c5f6ecd7, 0x5081bf5196b7, 0x519b699cc858,
        0x52b5c7b54739, 0x53d0dc7e5293, 0x54ecaae1c410, 0x560935d030fa,
        0x572680410c05, 0x58448d32c79d, 0x59635faaf8c6, 0x5a82fab67a99,
        0x5ba361699250, 0x5cc496e013f4, 0x5de69e3d87af, 0x5f097aad4fba,
        0x602d2f62cef7, 0x6151bf99903c, 0x62772e956e44, 0x639d7fa2bc62,
        0x64c4b6166fe3, 0x65ecd54e4a2f, 0x6715e0b103b6, 0x683fdbae7793,
        0x696ac9bfd010, 0x6a96ae67b3e5, 0x6bc38d327460, 0x6cf169b63c5e,
        0x6e2047934027, 0x6f502a73ee30, 0x7081160d20ca, 0x71b30e1e50c4,
        0x72e61671c902, 0x741a32dcdb14, 0x754f674014ce, 0x7685b78776f1,
        0x77bd27aaacdf, 0x78f5bbad456a, 0x7a2f779eecc6, 0x7b6a5f9ba798,
        0x7ca677cc0f3b, 0x7de3c4658f3a, 0x7f2249aaa402, 0x80620beb1ade,
        0x81a30f845343, 0x82e558e18167, 0x8428ec7bf244, 0x856dcedb50fd,
        0x86b40495edb2, 0x87fb925105d4, 0x89447cc10df7, 0x8a8ec8a9fd38,
        0x8bda7adf9a3a, 0x8d279845c9c8, 0x8e7625d0df1d, 0x8fc62885edf5,
        0x9117a57b1e56, 0x926aa1d80230, 0x93bf22d5ecd9, 0x95152dc04c77,
        0x966cc7f5055c, 0x97c5f6e4cf6a, 0x9920c0139589, 0x9a7d2918d73e,
        0x9bdb37a00c74, 0x9d3af1690b7f, 0x9e9c5c487170, 0x9fff7e280cc8,
        0xa1645d074a9c, 0xa2cafefba635, 0xa4336a311b44, 0xa59da4ea9aba,
        0xa709b582825b, 0xa877a26b1710, 0xa9e7722f0226, 0xab592b71d172,
        0xacccd4f07a89, 0xae427581e10e, 0xafba14176037, 0xb133b7bd579e,
        0xb2af679bbb78, 0xb42d2af6a846, 0xb5ad092efa20, 0xb72f09c2e7b0,
        0xb8b3344ea0f7, 0xba39908cf204, 0xbbc22657e9a4, 0xbd4cfda98446,
        0xbeda1e9c5b16, 0xc069916c5788, 0xc1fb5e776b5d, 0xc38f8e3e4d5d,
        0xc52629653ad4, 0xc6bf38b4be05, 0xc85ac51a79b3, 0xc9f8d7a9f9ea,
        0xcb99799d8a31, 0xcd3cb4571149, 0xcee29160f2b6, 0xd08b1a6ef628,
        0xd236595f3506, 0xd3e4583b0e42, 0xd595213820ac, 0xd748beb94bf8,
        0xd8ff3b4fb8aa, 0xdab8a1bbe728, 0xdc74fceec61c, 0xde34580ad07c,
        0xdff6be65335a, 0xe1bc3b86fbd4, 0xe384db2e4d54, 0xe550a94fa077,
        0xe71fb2170ad8, 0xe8f201e9900c, 0xeac7a5667c22, 0xeca0a968c7ec,
        0xee7d1b088777, 0xf05d079c62f6, 0xf2407cbb1a84, 0xf427883d1520,
        0xf612383dfb34, 0xf8009b1e5d22, 0xf9f2bf85662a, 0xfbe8b4629c26,
        0xfde288efac8c, 0xffe04cb24720};
};
template <class Any>
constexpr uint64_t Tangent64Table<Any>::tangent[];

}  // namespace portable
}  // namespace fixedpoint
