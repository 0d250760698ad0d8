package org.sami.crw.sim.boat;

/** The same over protected links. */
class CutLinkOverTlsTest extends CutLinkTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
