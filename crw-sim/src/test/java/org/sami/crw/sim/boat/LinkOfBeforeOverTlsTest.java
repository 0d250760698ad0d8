package org.sami.crw.sim.boat;

/** The same over protected links. */
class LinkOfBeforeOverTlsTest extends LinkOfBeforeTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
