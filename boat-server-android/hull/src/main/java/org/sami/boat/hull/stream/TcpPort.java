package org.sami.boat.hull.stream;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;

/** A device at a TCP address. */
public final class TcpPort implements StreamPort {
    private static final int CONNECT_MS = 3000;
    private static final int MAX_PORT = 65_535;

    private final String host;
    private final int port;

    /** An address, not connected to yet. */
    public TcpPort(String host, int port) {
        if (host.isEmpty() || port < 1 || port > MAX_PORT) {
            throw new IllegalArgumentException("no address: " + host + ":" + port);
        }
        this.host = host;
        this.port = port;
    }

    @Override
    public String name() {
        return host + ":" + port;
    }

    @Override
    public StreamConnection open() throws IOException {
        Socket socket = new Socket();
        try {
            socket.connect(new InetSocketAddress(host, port), CONNECT_MS);
            socket.setTcpNoDelay(true);
            return new TcpConnection(socket);
        } catch (IOException e) {
            socket.close();
            throw new IOException(why(e), e);
        }
    }

    private static String why(IOException e) {
        if (e instanceof UnknownHostException) {
            return "no such host";
        }
        if (e instanceof ConnectException) {
            return "connection refused";
        }
        return e instanceof SocketTimeoutException ? "no answer within " + CONNECT_MS / 1000 + " s" : e.toString();
    }

    /** A socket. */
    private static final class TcpConnection implements StreamConnection {
        private final Socket socket;
        private final InputStream in;
        private final OutputStream out;

        TcpConnection(Socket socket) throws IOException {
            this.socket = socket;
            in = socket.getInputStream();
            out = socket.getOutputStream();
        }

        @Override
        public InputStream in() {
            return in;
        }

        @Override
        public OutputStream out() {
            return out;
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }
}
