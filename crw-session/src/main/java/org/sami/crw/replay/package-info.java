/** Replays of sessions: what lay before the operator at any moment of a journal (docs/replay.md). No window, and nothing that acts on boats. */
@NullMarked
package org.sami.crw.replay;

import org.jspecify.annotations.NullMarked;
