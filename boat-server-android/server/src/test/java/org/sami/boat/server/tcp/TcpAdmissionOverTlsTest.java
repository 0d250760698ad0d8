package org.sami.boat.server.tcp;

import java.io.IOException;
import java.util.function.UnaryOperator;
import org.sami.boat.server.ServerConfig;

/** The same over protected links. */
class TcpAdmissionOverTlsTest extends TcpAdmissionTest {
    @Override
    TcpBench bench(UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp) throws IOException {
        return TcpBench.overTls(boat, tcp);
    }
}
