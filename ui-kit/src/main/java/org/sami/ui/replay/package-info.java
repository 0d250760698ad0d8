/** Time lines: what happened when in a session, where a replay of it is, and what keeps it going. What is shown then is the window's. */
@NullMarked
package org.sami.ui.replay;

import org.jspecify.annotations.NullMarked;
