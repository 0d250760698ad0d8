package org.sami.crw.sim.boat;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.atomic.AtomicInteger;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.link.security.SecureLink;

/** What answers at an address and is no boat, or one that has lost its mind: to each that connects it says what it is given. */
final class MalformedPeer implements AutoCloseable {

    /** What is said on one connection; it is closed afterwards. */
    interface Speech {
        void speak(int connection, OutputStream to) throws IOException;
    }

    private final ServerSocket socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final AtomicInteger spoken = new AtomicInteger();
    private final LinkSecurity security;
    private final Speech speech;

    MalformedPeer(Speech speech) throws IOException {
        this(new OpenLinks(), speech);
    }

    /** One that speaks over links of some kind. */
    MalformedPeer(LinkSecurity security, Speech speech) throws IOException {
        this.security = security;
        this.speech = speech;
        Thread thread = new Thread(this::accept, "raving-boat");
        thread.setDaemon(true);
        thread.start();
    }

    InetSocketAddress address() {
        return (InetSocketAddress) socket.getLocalSocketAddress();
    }

    /** How many connections have heard it to the end, or have had enough before. */
    int spoken() {
        return spoken.get();
    }

    private void accept() {
        while (!socket.isClosed()) {
            try (Socket base = socket.accept()) {
                base.setSoTimeout(2000);
                SecureLink link = security.accept(base);
                speech.speak(spoken.get(), link.out());
                base.shutdownOutput();
                while (link.in().read() >= 0) {
                    // the base closes when it has read to the end
                }
            } catch (IOException e) {
                // the base has closed first, or the test is over
            }
            spoken.incrementAndGet();
        }
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
