/**
 * The pictures that boats have taken, as immutable values: which there are, and whether they are on this machine yet.
 *
 * <p>Not here: how pictures come from boats ({@code org.sami.crw.session.picture}), and how they are decoded and drawn.
 */
@NullMarked
package org.sami.crw.operator.picture;

import org.jspecify.annotations.NullMarked;
