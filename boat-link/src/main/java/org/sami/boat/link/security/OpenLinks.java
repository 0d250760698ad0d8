package org.sami.boat.link.security;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.util.Optional;

/** No protection: whoever reaches the port commands the boat. For simulated boats on loopback. */
public final class OpenLinks implements LinkSecurity {
    @Override
    public SecureLink accept(Socket socket) throws IOException {
        return of(socket, socket.getInputStream());
    }

    @Override
    public SecureLink connect(Socket socket) throws IOException {
        return of(socket, new PlainInput(socket));
    }

    private static SecureLink of(Socket socket, InputStream in) {
        return new SecureLink() {
            @Override
            public InputStream in() {
                return in;
            }

            @Override
            public OutputStream out() throws IOException {
                return socket.getOutputStream();
            }

            @Override
            public Optional<Fingerprint> peer() {
                return Optional.empty();
            }
        };
    }
}
