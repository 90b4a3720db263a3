#pragma once
// What may be wrong with a level or its file, and what an edit may have to say.

#include "core/physics/def/codes.h"

namespace spacetow {

inline constexpr std::string_view readingCodes[] = {
    "text-too-large",    "empty-file",       "not-utf8",        "zero-byte",           "byte-order-mark",
    "not-json",          "unexpected-end",   "open-text",       "control-character",   "not-finite-literal",
    "trailing-comma",    "number-too-large", "nested-too-deep", "too-many-values",     "too-large-to-save",
    "too-many-vertices", "duplicate-field",  "not-a-level",     "missing-schema",      "newer-schema",
    "bad-schema",        "missing-field",    "unknown-field",   "not-a-number",        "not-an-integer",
    "not-a-depth",       "not-a-flag",       "not-a-text",      "not-a-point",         "not-a-list",
    "not-an-object",     "not-touches",      "unknown-choice",  "unknown-tag",         "bad-key",
    "duplicate-key",     "key-taken",        "duplicate-tag",   "duplicate-tag-index", "bad-tag-index",
    "bad-tag-name",      "bad-color",        "more-problems",
};

inline constexpr std::string_view lintCodes[] = {
    "mass-not-usable",
    "body-not-usable",
    "not-positive",
    "ship-missing",
    "payload-missing",
    "finish-missing",
    "several-ships",
    "several-payloads",
    "several-finishes",
    "ship-in-wall",
    "payload-in-wall",
    "cave-inside-out",
    "chain-too-short",
    "chain-without-length",
    "zero-length-wall",
    "repeated-vertex",
    "polygon-too-large",
    "polygon-too-few-vertices",
    "polygon-crosses-itself",
    "polygon-not-simple",
    "polygon-flat",
    "polygon-clockwise",
    "parent-missing",
    "parent-no-group",
    "parent-circle",
    "layer-in-group",
    "hidden-in-play",
    "connector-end-missing",
    "connector-end-no-body",
    "connector-same-ends",
    "connector-moves-nothing",
    "spring-too-stiff",
    "damping-too-strong",
    "touches-nothing",
    "idle-points",
    "wall-reversed",
    "walls-disagree",
    "chain-nearly-closed",
    "chain-gap",
    "wall-twice",
    "walls-overlap",
    "walls-overlap-themselves",
    "object-twice",
    "wall-too-thin",
    "no-back-reaches-through",
    "depth-reaches-through",
    "shelf-without-back",
    "ship-outside",
    "payload-outside",
    "finish-outside",
    "finish-without-length",
    "payload-on-finish",
    "gravity-too-strong",
    "payload-too-heavy",
    "background-unknown",
    "wall-not-tagged",
    "walls-never-meet",
    "leak-wall-reversed",
    "leak-chain-reversed",
    "leak-edge-reversed",
    "leak-edges-reversed",
    "leak-not-closed",
    "leak-wall-missing",
    "leak-opening",
    "leak-gap",
    "leak-too-short",
    "leak-between",
};

/// What an edit refuses, or does beside what it is for.
inline constexpr std::string_view editCodes[] = {
    "combine-too-few", "combine-no-polygon", "combine-unnamed-no-polygon",
    "combine-too-far", "combine-empty",      "combine-not-simple",
    "tags-made",       "tag-renamed",        "tags-dropped",
};

/// What kind of thing an object without a name is: arguments of other codes.
inline constexpr std::string_view kindCodes[] = {
    "kind-edges", "kind-lines", "kind-polygon", "kind-circle", "kind-body",
};

using LevelCode = PhysicsCode::And<readingCodes, lintCodes, editCodes, kindCodes>;

/// What the edits are called that cure a problem.
inline constexpr std::string_view fixCodes[] = {
    "fix-remove-idle-points", "fix-merge-points", "fix-turn-outline", "fix-reverse",          "fix-close-gap",
    "fix-add-wall",           "fix-remove-twice", "fix-limit-depth",  "fix-plain-background", "fix-put-to-top",
    "fix-renumber",           "fix-tag-as-wall",  "fix-show",         "fix-remove",           "fix-remove-unbuildable",
    "fix-untangle",           "fix-move-free",
};

using FixCode = CodeOf<fixCodes>;

} // namespace spacetow
