/** What all panels work on: session, commands, selected boats, notices in the strip at the top. */
@NullMarked
package org.sami.crw.gui.context;

import org.jspecify.annotations.NullMarked;
