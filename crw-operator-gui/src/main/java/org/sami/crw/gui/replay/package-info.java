/** Replays: the window over a journal, its time line, and what keeps it going. Nothing here acts on boats or missions. */
@NullMarked
package org.sami.crw.gui.replay;

import org.jspecify.annotations.NullMarked;
