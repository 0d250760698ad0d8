package org.sami.boat.link.security;

import java.io.FilterInputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;

/**
 * What comes over a plain link. A peer that takes only protected links answers with an alert of TLS; its first byte is no beginning of a frame, whose length
 * would be 350 MB.
 */
final class PlainInput extends FilterInputStream {
    private static final int TLS_ALERT = 0x15;

    private final Socket socket;
    private boolean begun;

    PlainInput(Socket socket) throws IOException {
        super(socket.getInputStream());
        this.socket = socket;
    }

    @Override
    public int read() throws IOException {
        int one = super.read();
        check(one);
        return one;
    }

    @Override
    public int read(byte[] bytes, int offset, int length) throws IOException {
        int read = super.read(bytes, offset, length);
        if (read > 0) {
            check(bytes[offset]);
        }
        return read;
    }

    private void check(int first) throws IOException {
        if (!begun && first == TLS_ALERT) {
            InetSocketAddress address = (InetSocketAddress) socket.getRemoteSocketAddress();
            throw new LinkRefusedException("the boat takes only protected links: crw keys pair "
                    + address.getHostString() + ":" + address.getPort());
        }
        begun = true;
    }
}
