/** Replays: the window over a journal, its time line, and what keeps it going. Nothing here acts on boats or missions. */
package org.sami.crw.gui.replay;
