package org.sami.crw.sim.boat;

/** The same over protected links. */
class MovedBoatOverTlsTest extends MovedBoatTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
