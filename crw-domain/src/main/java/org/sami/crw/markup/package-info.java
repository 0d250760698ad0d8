/**
 * The markups of an interaction as values for its display (appendix .2.3): read once, without a window.
 *
 * <p>Not here: markups for the engine ({@code spn.engine}: Mixed Initiative Trigger, Priority), for services ({@code org.sami.crw.handler}: Optimize,
 * Selection Options), and their use by models ({@code org.sami.crw.operator}).
 */
@NullMarked
package org.sami.crw.markup;

import org.jspecify.annotations.NullMarked;
