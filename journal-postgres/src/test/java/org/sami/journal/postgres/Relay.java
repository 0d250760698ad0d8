package org.sami.journal.postgres;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Optional;

/** A port that stays the same while the server behind it is another; leads nowhere while there is none. */
final class Relay implements AutoCloseable {
    private final ServerSocket door;
    private volatile Optional<Integer> target = Optional.empty();

    Relay() throws IOException {
        door = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        start(this::accept);
    }

    int port() {
        return door.getLocalPort();
    }

    /** New connections lead to this port of this machine. */
    void leadTo(int port) {
        target = Optional.of(port);
    }

    private void accept() {
        while (!door.isClosed()) {
            try {
                Socket front = door.accept();
                try {
                    Socket back = new Socket(InetAddress.getLoopbackAddress(), target.orElseThrow(IOException::new));
                    start(() -> copy(front, back));
                    start(() -> copy(back, front));
                } catch (IOException nobody) {
                    front.close();
                }
            } catch (IOException closed) {
                // the loop looks whether it is over
            }
        }
    }

    private static void copy(Socket from, Socket to) {
        try (Socket source = from;
                Socket sink = to) {
            InputStream in = source.getInputStream();
            OutputStream out = sink.getOutputStream();
            in.transferTo(out);
        } catch (IOException cut) {
            // both are closed
        }
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "relay");
        thread.setDaemon(true);
        thread.start();
    }

    @Override
    public void close() throws IOException {
        door.close();
    }
}
