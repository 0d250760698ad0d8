package org.sami.crw.sim.boat;

/** The same over protected links. */
class MalformedPeerOverTlsTest extends MalformedPeerTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
