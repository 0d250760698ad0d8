package org.sami.crw.sim.boat;

/** The same over protected links. */
class EverNewNamesOverTlsTest extends EverNewNamesTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
