/**
 * Why a boat moves or does not, in words for the operator, and the parts of such sentences.
 *
 * <p>Does not belong here: which of the reasons holds ({@code BoatExplainer} of the package above finds it).
 */
@NullMarked
package org.sami.crw.proxy.explanation;

import org.jspecify.annotations.NullMarked;
