/**
 * A journal of the field on the plan that is open: tokens over a time line, stops at breakpoints. It knows journals generically; whose words
 * the telemetry has is the domain's and is not read. What a journal holds is told by {@code org.sami.spn.replay}.
 */
package org.sami.dreamm.replay;
