/**
 * Running the test cases that are saved with plans.
 *
 * <p>Belongs here: taking a test case through a stepper and saying as a finding where it went another way. Does not belong
 * here: how a test case is written down ({@code spn.model}, {@code spn.json}), how steps are taken and recorded
 * ({@code spn.stepping}).
 */
@NullMarked
package org.sami.spn.testcase;

import org.jspecify.annotations.NullMarked;
