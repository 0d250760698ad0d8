package org.sami.crw.sim.boat;

/** The same over protected links: what stands still or is cut lies in the middle of records then. */
class RoughNetworkOverTlsTest extends RoughNetworkTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
