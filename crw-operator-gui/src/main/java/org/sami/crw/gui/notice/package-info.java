/** What the operator is told and need not answer: messages and alarms. */
package org.sami.crw.gui.notice;
