/** How DREAMM begins: its command line, its folder of data, the project that is opened first. */
package org.sami.dreamm.start;
