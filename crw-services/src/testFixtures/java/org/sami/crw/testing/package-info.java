/** What tests and benchmarks of the boats domain compare with: seeded problems, and slow ways to solve them. */
package org.sami.crw.testing;
