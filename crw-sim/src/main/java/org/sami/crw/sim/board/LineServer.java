package org.sami.crw.sim.board;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import org.sami.boat.hull.stream.LineSplitter;

/**
 * A TCP port that sends the same lines to each client and reads theirs. A client too many takes the place of the oldest; one that does not read is dropped once
 * {@link #MAX_WAITING} pieces wait for it. Safe for use by several threads.
 */
final class LineServer implements Closeable {
    private static final int MAX_WAITING = 100;

    private final String name;
    private final int maxClients;
    private final int maxLine;
    private final Consumer<String> lines;
    private final ServerSocket socket = new ServerSocket();
    private final List<Client> clients = new ArrayList<>();
    private boolean refusing;

    LineServer(String name, InetSocketAddress address, int maxClients, int maxLine, Consumer<String> lines)
            throws IOException {
        this.name = name;
        this.maxClients = maxClients;
        this.maxLine = maxLine;
        this.lines = lines;
        try {
            socket.setReuseAddress(true);
            socket.bind(address);
        } catch (IOException e) {
            socket.close();
            throw e;
        }
        start(this::accept, name);
    }

    private static void start(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    InetSocketAddress address() {
        return (InetSocketAddress) socket.getLocalSocketAddress();
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                enter(new Client(socket.accept()));
            } catch (IOException e) {
                // closed, or a client that has gone already
            }
        }
    }

    private synchronized void enter(Client client) {
        if (refusing || socket.isClosed()) {
            client.drop();
            return;
        }
        if (clients.size() >= maxClients) {
            clients.get(0).drop();
        }
        clients.add(client);
        start(client::read, name + "-reads");
        start(client::write, name + "-writes");
    }

    synchronized boolean hasClients() {
        return !clients.isEmpty();
    }

    /** Drops all clients and takes no more, or takes them again. */
    synchronized void setRefusing(boolean now) {
        refusing = now;
        if (now) {
            List.copyOf(clients).forEach(Client::drop);
        }
    }

    synchronized void send(byte[] bytes) {
        if (bytes.length > 0) {
            List.copyOf(clients).forEach(client -> client.offer(bytes));
        }
    }

    private synchronized void leave(Client client) {
        clients.remove(client);
    }

    @Override
    public void close() throws IOException {
        socket.close();
        setRefusing(true);
    }

    /** One client. */
    private final class Client {
        private final Socket to;
        private final Deque<byte[]> waiting = new ArrayDeque<>();
        private boolean gone;

        Client(Socket to) throws IOException {
            this.to = to;
            to.setTcpNoDelay(true);
        }

        void offer(byte[] bytes) {
            synchronized (waiting) {
                if (waiting.size() < MAX_WAITING) {
                    waiting.add(bytes);
                    waiting.notifyAll();
                    return;
                }
            }
            drop();
        }

        void read() {
            byte[] buffer = new byte[4096];
            LineSplitter splitter = new LineSplitter(maxLine, lines);
            try {
                for (int count = to.getInputStream().read(buffer);
                        count >= 0;
                        count = to.getInputStream().read(buffer)) {
                    splitter.feed(buffer, count);
                }
            } catch (IOException e) {
                // it has gone
            }
            drop();
        }

        void write() {
            try {
                while (true) {
                    byte[] next;
                    synchronized (waiting) {
                        while (waiting.isEmpty() && !gone) {
                            waiting.wait();
                        }
                        if (gone) {
                            return;
                        }
                        next = waiting.remove();
                    }
                    to.getOutputStream().write(next);
                }
            } catch (IOException | InterruptedException e) {
                drop();
            }
        }

        void drop() {
            leave(this);
            synchronized (waiting) {
                gone = true;
                waiting.notifyAll();
            }
            try {
                to.close();
            } catch (IOException e) {
                // it is closed
            }
        }
    }
}
