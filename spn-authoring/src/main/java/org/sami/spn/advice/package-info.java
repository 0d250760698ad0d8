/**
 * What helps an author with a finding, whichever check it comes from.
 *
 * <p>Belongs here: the advice of all checks, by the code of the finding. Does not belong here: the advice itself, which stands next to
 * the check that reports the code.
 */
@NullMarked
package org.sami.spn.advice;

import org.jspecify.annotations.NullMarked;
