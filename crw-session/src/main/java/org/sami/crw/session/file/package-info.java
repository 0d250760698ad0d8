/** Fetching files of a session's boats as a person does it at a window: which boats, how far, what came and what did not. No window, no link. */
@NullMarked
package org.sami.crw.session.file;

import org.jspecify.annotations.NullMarked;
