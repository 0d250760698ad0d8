/**
 * A journal of the field on the plan that is open: tokens over a time line, stops at breakpoints. It knows journals generically; whose words
 * the telemetry has is the domain's and is not read. {@code org.sami.spn.replay} reads the journal.
 */
@NullMarked
package org.sami.dreamm.replay;

import org.jspecify.annotations.NullMarked;
