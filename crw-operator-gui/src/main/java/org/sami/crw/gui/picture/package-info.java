/**
 * How the window shows the pictures that boats took: small with messages and decisions, and large in a panel of their own. They are decoded on a thread of this package.
 *
 * <p>Not here: which pictures there are ({@code org.sami.crw.operator.picture}), and how a file is decoded ({@code org.sami.picture.photo}).
 */
@NullMarked
package org.sami.crw.gui.picture;

import org.jspecify.annotations.NullMarked;
