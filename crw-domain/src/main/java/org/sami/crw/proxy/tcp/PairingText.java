package org.sami.crw.proxy.tcp;

import java.util.Optional;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;

/**
 * What a person types or pastes in order to pair a boat: its six words, or the text of its QR code.
 *
 * @param words the secret
 * @param code all that the QR code says; empty where words were typed
 */
public record PairingText(PairingSecret words, Optional<PairingCode> code) {
    /**
     * Reads it.
     *
     * @throws IllegalArgumentException in words: which word is none of the list, how many are missing, or what of the code is damaged
     */
    public static PairingText parse(String text) {
        if (PairingCode.isMeant(text)) {
            PairingCode code = PairingCode.parse(text);
            return new PairingText(code.words(), Optional.of(code));
        }
        return new PairingText(PairingSecret.parse(text), Optional.empty());
    }

    /** The boat's key, where the QR code has said it. */
    public Optional<Fingerprint> key() {
        return code.map(PairingCode::key);
    }

    /**
     * Where the boat is.
     *
     * @param typed {@code HOST:PORT}, which counts before the address of the code, as a boat may have several; may be blank
     * @throws IllegalArgumentException in words, if neither is an address
     */
    public BoatAddress address(String typed) {
        String said = typed.isBlank() ? code.map(PairingCode::address).orElse("") : typed;
        if (said.isBlank()) {
            throw new IllegalArgumentException("the address of the boat's server is needed, such as 10.0.0.11:11411");
        }
        return BoatAddress.parse(said);
    }
}
