package org.sami.session.client;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;

/** Stands between a front and a server on loopback, and cuts all connections when a test says so, or when the server has said something. */
final class CuttableRelay implements Closeable {
    private final ServerSocket listening = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final InetSocketAddress server;
    private final List<Socket> sockets = new CopyOnWriteArrayList<>();
    private final List<Socket> stalled = new CopyOnWriteArrayList<>();
    private final CountDownLatch closed = new CountDownLatch(1);
    private final AtomicLong mostBytes = new AtomicLong(Long.MAX_VALUE);
    private final AtomicReference<Optional<String>> lastWords = new AtomicReference<>(Optional.empty());

    CuttableRelay(InetSocketAddress server) throws IOException {
        this.server = server;
        start(this::accept);
    }

    private static void start(Runnable work) {
        Thread one = new Thread(work, "relay");
        one.setDaemon(true);
        one.start();
    }

    int port() {
        return listening.getLocalPort();
    }

    private void accept() {
        try {
            while (true) {
                Socket front = listening.accept();
                Socket behind = new Socket(server.getAddress(), server.getPort());
                sockets.add(front);
                sockets.add(behind);
                start(() -> pump(front, behind));
                start(() -> pump(behind, front));
            }
        } catch (IOException closed) {
            // the test is over
        }
    }

    private void pump(Socket from, Socket to) {
        byte[] buffer = new byte[8192];
        long bytes = 0;
        try (from;
                to;
                InputStream in = from.getInputStream();
                OutputStream out = to.getOutputStream()) {
            for (int read = in.read(buffer); read >= 0; read = in.read(buffer)) {
                out.write(buffer, 0, read);
                out.flush();
                bytes += read;
                if (bytes > mostBytes.get()) {
                    stall(from, to);
                    return;
                }
                String text = new String(buffer, 0, read, StandardCharsets.ISO_8859_1);
                if (lastWords
                        .getAndUpdate(words -> words.filter(one -> !text.contains(one)))
                        .filter(text::contains)
                        .isPresent()) {
                    return;
                }
            }
        } catch (IOException cut) {
            // both ends notice it
        }
    }

    private void stall(Socket from, Socket to) {
        mostBytes.set(Long.MAX_VALUE);
        sockets.removeAll(List.of(from, to));
        stalled.addAll(List.of(from, to));
        try {
            closed.await();
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
    }

    /** Relays no more of the first connection that carries more than so many bytes to one side, and leaves it open, as where a machine loses its power. */
    void stallAfter(long bytes) {
        mostBytes.set(bytes);
    }

    /** Whether a connection stands still. */
    boolean hasStalled() {
        return !stalled.isEmpty();
    }

    /** Cuts the connection on which the server first says these words, right after them; later ones are relayed. */
    void cutAfter(String words) {
        lastWords.set(Optional.of(words));
    }

    /** Cuts all connections but one that stands still; new ones are relayed. */
    void cut() throws IOException {
        for (Socket socket : sockets) {
            socket.close();
        }
        sockets.clear();
    }

    @Override
    public void close() throws IOException {
        listening.close();
        cut();
        closed.countDown();
        for (Socket socket : stalled) {
            socket.close();
        }
    }
}
