package org.sami.mavlink.format;

import io.dronefleet.mavlink.annotations.MavlinkFieldInfo;
import io.dronefleet.mavlink.annotations.MavlinkMessageBuilder;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.util.WireFieldInfoComparator;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * One kind of message, from the annotations of the library's class. The library evaluates them again for each message, which takes some twenty times as long.
 * Safe for use by several threads.
 */
public final class MessageFormat {
    private final Class<?> kind;
    private final int checksumExtra;
    private volatile Optional<Layout> layout = Optional.empty(); // worked out for the first message that is read

    /** How to read a message. */
    private record Layout(Method builder, List<FieldFormat> fields, int length, Method build) {}

    /** The format of a class of the library. */
    MessageFormat(Class<?> kind) {
        this.kind = kind;
        checksumExtra = kind.getAnnotation(MavlinkMessageInfo.class).crc();
    }

    /** The library's class of such messages. */
    public Class<?> kind() {
        return kind;
    }

    /** The number that goes into the checksum, so that both ends know the same definition (CRC_EXTRA). */
    public int checksumExtra() {
        return checksumExtra;
    }

    /**
     * Reads a message.
     *
     * @param payload its bytes; zeros at its end may be missing, and fields of later definitions may follow
     * @return a message of the library
     */
    public Object read(byte[] payload) {
        Layout known = layout.orElseGet(this::layout);
        byte[] whole = payload.length < known.length ? Arrays.copyOf(payload, known.length) : payload;
        try {
            Object builder = known.builder.invoke(null);
            for (FieldFormat field : known.fields) {
                field.read(whole, builder);
            }
            return known.build.invoke(builder);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the library's " + kind.getSimpleName() + " cannot be made", e);
        }
    }

    private Layout layout() {
        try {
            Method builder = Arrays.stream(kind.getMethods())
                    .filter(method -> method.isAnnotationPresent(MavlinkMessageBuilder.class))
                    .findFirst()
                    .orElseThrow();
            Class<?> made = builder.getReturnType();
            List<FieldFormat> fields = new ArrayList<>();
            int length = 0;
            for (Method setter : settersAsSent(made)) {
                fields.add(new FieldFormat(setter, length));
                length += FieldFormat.length(FieldFormat.info(setter));
            }
            Layout known = new Layout(builder, fields, length, made.getMethod("build"));
            layout = Optional.of(known);
            return known;
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the library's " + kind.getSimpleName() + " has no builder", e);
        }
    }

    private static List<Method> settersAsSent(Class<?> builder) {
        Comparator<MavlinkFieldInfo> asSent = new WireFieldInfoComparator();
        return Arrays.stream(builder.getMethods())
                .filter(method -> method.isAnnotationPresent(MavlinkFieldInfo.class))
                .sorted(Comparator.comparing(FieldFormat::info, asSent))
                .toList();
    }
}
