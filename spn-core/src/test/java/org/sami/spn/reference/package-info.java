/**
 * The engine held against docs/semantics.md: a slow interpreter of its rules, random plans and inputs, and the test
 * that runs both and compares.
 *
 * <p>Belongs here: whatever is needed to judge the engine from outside. Does not belong here: tests of single rules (they
 * stand with the engine), anything fast. The interpreter shares no class with {@code org.sami.spn.engine}.
 */
package org.sami.spn.reference;
