package org.sami.boat.link.security;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** The 1,024 words of which pairing secrets are made: plain English, four to eight letters, no two with the same first four letters. */
final class PairingWordList {
    /** No two words begin with the same letters, so many. */
    static final int PREFIX = 4;

    private static final List<String> WORDS = read();

    private PairingWordList() {}

    private static List<String> read() {
        List<String> words = new ArrayList<>();
        try (InputStream in = PairingWordList.class.getResourceAsStream("pairing-words.txt")) {
            if (in == null) {
                throw new IllegalStateException("the words for pairing are not in this program");
            }
            BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                words.add(line);
            }
            return words;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static int size() {
        return WORDS.size();
    }

    static String word(int index) {
        return WORDS.get(index);
    }

    static List<String> beginningWith(String letters, int most) {
        List<String> found = new ArrayList<>();
        for (String word : WORDS) {
            if (word.startsWith(letters) && found.size() < most) {
                found.add(word);
            }
        }
        return found;
    }

    /** The word that begins with the same four letters. */
    static String find(String typed) {
        for (String word : WORDS) {
            if (typed.length() >= PREFIX
                    && word.startsWith(typed.substring(0, PREFIX))
                    && (typed.length() == PREFIX || typed.equals(word))) {
                return word;
            }
        }
        throw new IllegalArgumentException("'" + typed + "' is none of the words that a boat shows");
    }
}
