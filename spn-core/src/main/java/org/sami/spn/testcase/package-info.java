/**
 * Running the test cases that are saved with plans.
 *
 * <p>Belongs here: taking a test case step by step through the engine and saying where it went another way. Does not belong
 * here: how a test case is written down ({@code spn.model}, {@code spn.json}), how steps are recorded while an author tries
 * a plan.
 */
package org.sami.spn.testcase;
