/**
 * The robot's run over the real window: mistakes of operators and attacks from outside, a row each, with what must hold after it (docs/robot-run.md). Does not
 * belong here: tests of single panels.
 */
package org.sami.crw.gui.robot;
