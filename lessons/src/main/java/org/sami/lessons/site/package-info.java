/** The course as a folder of pages, to be read without DREAMM. */
@NullMarked
package org.sami.lessons.site;

import org.jspecify.annotations.NullMarked;
