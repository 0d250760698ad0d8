/**
 * Small nets, vocabularies and sessions for tests of everything that runs plans.
 *
 * <p>Belongs here: builders that make a net readable in a test. Does not belong here: expectations of any one test.
 */
package org.sami.spn.testing;
