/** Time lines: what happened when in a session, where a replay of it is, and what keeps it going. What is shown then is the window's. */
package org.sami.ui.replay;
