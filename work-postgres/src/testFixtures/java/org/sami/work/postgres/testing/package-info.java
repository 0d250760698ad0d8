/** A database for tests of this module and of those that divide work. */
package org.sami.work.postgres.testing;
