package org.sami.crw.sim.boat;

/** The same over protected links. */
class FlippedBitsOverTlsTest extends FlippedBitsTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
