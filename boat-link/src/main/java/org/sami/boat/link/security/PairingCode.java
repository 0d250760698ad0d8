package org.sami.boat.link.security;

import java.io.UnsupportedEncodingException;
import java.net.URLDecoder;
import java.net.URLEncoder;
import java.util.Base64;
import java.util.Objects;

/**
 * What the QR code says that a boat shows while it waits to be paired: where it is reached, its key, its six words and its name. The text is
 *
 * <pre>SAMI1;192.168.43.7:5001;n4bQgYhMfWWaL-qgxVrQFaO_TxsrC4Is0V1sFbDwCgg;able.abou.abov.abse.abso.acce;anna</pre>
 *
 * <ol>
 *   <li>{@code SAMI} and the version of this form, 1;
 *   <li>{@code HOST:PORT} of the boat's server, an IPv6 address in brackets; empty where the boat does not know it, so that a person types it;
 *   <li>the {@link Fingerprint} of the boat's key, its 32 bytes in Base64 for URLs without padding;
 *   <li>the first four letters of each of the six words, with dots between them;
 *   <li>the boat's name in UTF-8, as in a URL's query: what is no letter or digit as {@code %XX}, a space as {@code +}.
 * </ol>
 *
 * <p>All characters are ASCII, about 110 of them: a QR code with 41 by 41 modules (version 6) at error correction L. Whoever reads it knows the words, so it
 * is shown only as long as they count. Immutable.
 */
public final class PairingCode {
    /** The most characters that a text of this form has. */
    public static final int MOST_CHARACTERS = 1500;

    private static final String BEGIN = "SAMI";
    private static final String VERSION = "1";
    private static final int PARTS = 5;
    private static final int KEY_BYTES = 32;
    private static final String ADDRESS = "[A-Za-z0-9._:%\\[\\]-]{0,200}";

    private final String address;
    private final String boatName;
    private final Fingerprint key;
    private final PairingSecret words;

    /**
     * What a boat shows.
     *
     * @param address {@code HOST:PORT} at which a base on the same network reaches the boat; empty if it is not known
     * @param boatName 1 to 100 printable characters
     * @throws IllegalArgumentException naming the value that does not fit
     */
    public PairingCode(String address, String boatName, Fingerprint key, PairingSecret words) {
        this.address = Objects.requireNonNull(address, "address");
        this.boatName = Objects.requireNonNull(boatName, "boatName");
        this.key = Objects.requireNonNull(key, "key");
        this.words = Objects.requireNonNull(words, "words");
        if (!address.matches(ADDRESS)) {
            throw new IllegalArgumentException("'" + address + "' is no HOST:PORT");
        }
        if (!boatName.matches("\\P{C}{1,100}")) {
            throw new IllegalArgumentException("a boat's name has 1 to 100 printable characters");
        }
    }

    /** Whether a text is meant as such a code, of whichever version; it may still be damaged. */
    public static boolean isMeant(String text) {
        return text.trim().matches("(?s)" + BEGIN + "[0-9]+;.*");
    }

    /**
     * Reads the text of a QR code; white space in it does not count, as it comes in where a long line is copied.
     *
     * @throws IllegalArgumentException in words for a person: that the text is no such code, or of which version, or what of it is damaged
     */
    public static PairingCode parse(String text) {
        if (!isMeant(text)) {
            throw new IllegalArgumentException("this is no pairing code of a boat; one begins with " + BEGIN + VERSION);
        }
        if (text.length() > MOST_CHARACTERS) {
            throw new IllegalArgumentException("the pairing code is damaged: it is too long");
        }
        String[] parts = text.replaceAll("\\s", "").split(";", -1);
        String version = parts[0].substring(BEGIN.length());
        if (!version.equals(VERSION)) {
            throw new IllegalArgumentException("the pairing code is of version " + version
                    + ", this program reads version " + VERSION + ": both sides need the same release");
        }
        if (parts.length != PARTS) {
            throw new IllegalArgumentException(
                    "the pairing code is damaged: it has " + parts.length + " parts, not " + PARTS);
        }
        try {
            return new PairingCode(parts[1], decoded(parts[4]), key(parts[2]), PairingSecret.parse(parts[3]));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("the pairing code is damaged: " + e.getMessage(), e);
        }
    }

    private static Fingerprint key(String base64) {
        byte[] bytes;
        try {
            bytes = Base64.getUrlDecoder().decode(base64);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("the key in it cannot be read", e);
        }
        if (bytes.length != KEY_BYTES) {
            throw new IllegalArgumentException("the key in it is not whole");
        }
        return Fingerprint.parse(Hex.of(bytes));
    }

    private static String decoded(String name) {
        try {
            return URLDecoder.decode(name, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException("every Java and every Android has it", e);
        }
    }

    /** {@code HOST:PORT} of the boat's server; empty where the boat does not know it. */
    public String address() {
        return address;
    }

    /** The boat's name. */
    public String boatName() {
        return boatName;
    }

    /** The boat's key: what has another one is another boat, of whichever fleet. */
    public Fingerprint key() {
        return key;
    }

    /** The secret that the boat shows as six words. */
    public PairingSecret words() {
        return words;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PairingCode && other.toString().equals(toString());
    }

    @Override
    public int hashCode() {
        return toString().hashCode();
    }

    /** The text of the QR code; {@link #parse} reads it. */
    @Override
    public String toString() {
        try {
            return BEGIN + VERSION + ";" + address + ";"
                    + Base64.getUrlEncoder().withoutPadding().encodeToString(key.bytes()) + ";" + words.shortText()
                    + ";"
                    + URLEncoder.encode(boatName, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException("every Java and every Android has it", e);
        }
    }
}
