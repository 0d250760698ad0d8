/** What happens before there is a window: options, the data directory and its lock, the session that is begun or gone on with. */
@NullMarked
package org.sami.crw.gui.start;

import org.jspecify.annotations.NullMarked;
