/** Pairing boats and the keys of this base, in sheets of the window. What is judged and done stands in {@code org.sami.crw.session.key}. */
@NullMarked
package org.sami.crw.gui.key;

import org.jspecify.annotations.NullMarked;
