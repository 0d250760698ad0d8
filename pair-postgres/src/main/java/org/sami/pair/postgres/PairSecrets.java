package org.sami.pair.postgres;

import java.security.SecureRandom;
import java.util.Base64;

/**
 * What both bases of a pair know and nobody else: passwords of the database's roles, and the key of its TLS with the certificate that both trust.
 *
 * @param admin password of the role that owns the database
 * @param session password of the role by which sessions write
 * @param replica password of the role by which a replica reads
 * @param key the private key, PEM
 * @param certificate the certificate, PEM
 */
public record PairSecrets(String admin, String session, String replica, String key, String certificate) {
    private static final int PASSWORD_BYTES = 24;

    /** With new passwords. */
    public static PairSecrets of(String key, String certificate) {
        return new PairSecrets(password(), password(), password(), key, certificate);
    }

    private static String password() {
        byte[] bytes = new byte[PASSWORD_BYTES];
        new SecureRandom().nextBytes(bytes);
        return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
    }

    /** Names none of them: it may come into a log. */
    @Override
    public String toString() {
        return "the secrets of a pair";
    }
}
