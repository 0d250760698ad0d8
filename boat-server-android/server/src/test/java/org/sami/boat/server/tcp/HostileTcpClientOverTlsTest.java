package org.sami.boat.server.tcp;

import java.io.IOException;
import java.util.function.UnaryOperator;
import org.sami.boat.server.ServerConfig;

/** The same over protected links: who has a key may send rubbish in whole records. */
class HostileTcpClientOverTlsTest extends HostileTcpClientTest {
    @Override
    TcpBench bench(UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp) throws IOException {
        return TcpBench.overTls(boat, tcp);
    }

    /** Each cut takes a handshake, and the bytes come in records of whole frames here. */
    @Override
    int bytesBetweenCuts() {
        return 7;
    }
}
