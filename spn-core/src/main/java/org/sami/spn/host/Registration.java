package org.sami.spn.host;

/** Something that was added to a host and can be taken away again; closing it twice is harmless. */
@FunctionalInterface
public interface Registration extends AutoCloseable {
    @Override
    void close();
}
