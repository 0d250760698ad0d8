/** The sheet with which files of boats are fetched: their logs. What is fetched, and how far it is, is known by {@code org.sami.crw.session.file}. */
@NullMarked
package org.sami.crw.gui.file;

import org.jspecify.annotations.NullMarked;
