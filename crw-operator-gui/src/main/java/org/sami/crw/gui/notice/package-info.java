/** News for the operator that needs no answer: messages and alarms. */
package org.sami.crw.gui.notice;
