/** What happens before there is a window: options, the data directory and its lock, the session that is begun or gone on with. */
package org.sami.crw.gui.start;
