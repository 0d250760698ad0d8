package org.sami.mavlink.format;

import io.dronefleet.mavlink.annotations.MavlinkFieldInfo;
import io.dronefleet.mavlink.util.EnumValue;
import java.lang.reflect.Method;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** One field of a kind of message: where it lies in the payload, of which type it is, and how the library's builder takes it. Safe for use by several threads. */
final class FieldFormat {
    private static final int KEPT_VALUES = 256; // of an enumeration: more are flags in any combination
    private static final int BITS = 8; // of a byte
    private static final long BYTE = 0xff;

    private final Method setter;
    private final int from;
    private final int length;
    private final Reading reading;

    /** Reads a value that lies in some bytes from a place on. */
    private interface Reading {
        Object value(byte[] bytes, int from, int length);
    }

    /**
     * A field.
     *
     * @param setter takes it, in the library's builder
     * @param from its first byte in the payload
     */
    FieldFormat(Method setter, int from) {
        this.setter = setter;
        this.from = from;
        MavlinkFieldInfo info = info(setter);
        length = length(info);
        reading = reading(setter.getGenericParameterTypes()[0], info);
    }

    static MavlinkFieldInfo info(Method setter) {
        return setter.getAnnotation(MavlinkFieldInfo.class);
    }

    static int length(MavlinkFieldInfo info) {
        return info.unitSize() * Math.max(info.arraySize(), 1);
    }

    /** Gives the builder the field's value in a payload that is as long as it can be. */
    void read(byte[] payload, Object builder) throws ReflectiveOperationException {
        setter.invoke(builder, reading.value(payload, from, length));
    }

    private static Reading reading(Type type, MavlinkFieldInfo info) {
        boolean signed = info.signed();
        if (type == int.class || type == Integer.class) {
            return (bytes, from, length) -> (int) whole(bytes, from, length, signed);
        } else if (type == long.class || type == Long.class) {
            return (bytes, from, length) -> whole(bytes, from, length, signed);
        } else if (type == float.class || type == Float.class) {
            return (bytes, from, length) -> Float.intBitsToFloat((int) whole(bytes, from, Float.BYTES, false));
        } else if (type == double.class || type == Double.class) {
            return (bytes, from, length) -> Double.longBitsToDouble(whole(bytes, from, Double.BYTES, false));
        } else if (type == String.class) {
            return FieldFormat::text;
        } else if (type == byte[].class) {
            return (bytes, from, length) -> Arrays.copyOfRange(bytes, from, from + length);
        } else if (type == BigInteger.class) {
            return FieldFormat::big;
        } else if (type instanceof ParameterizedType some && some.getRawType() == EnumValue.class) {
            return new Entries(info.enumType(), signed);
        } else if (type instanceof ParameterizedType some && some.getRawType() == List.class) {
            return list(reading(some.getActualTypeArguments()[0], info), info.unitSize());
        }
        throw new IllegalArgumentException("the library has a field of " + type);
    }

    private static long whole(byte[] bytes, int from, int length, boolean signed) {
        long value = 0;
        for (int i = 0; i < length; i++) {
            value |= (bytes[from + i] & BYTE) << (BITS * i);
        }
        int unused = Long.SIZE - BITS * length;
        return signed ? value << unused >> unused : value;
    }

    private static Object text(byte[] bytes, int from, int length) {
        int used = 0;
        while (used < length && bytes[from + used] != 0) {
            used++;
        }
        return new String(bytes, from, used, StandardCharsets.UTF_8);
    }

    /** As the library reads it: with a sign, though these numbers have none. */
    private static Object big(byte[] bytes, int from, int length) {
        byte[] highestFirst = new byte[length];
        for (int i = 0; i < length; i++) {
            highestFirst[length - 1 - i] = bytes[from + i];
        }
        return new BigInteger(highestFirst);
    }

    private static Reading list(Reading unit, int unitSize) {
        return (bytes, from, length) -> {
            List<Object> units = new ArrayList<>(length / unitSize);
            for (int i = 0; i < length; i += unitSize) {
                units.add(unit.value(bytes, from + i, unitSize));
            }
            return Collections.unmodifiableList(units);
        };
    }

    /** Values of an enumeration, or flags. The library looks for the entry of a value by reflection: so each value is asked for once. */
    private static final class Entries implements Reading {
        @SuppressWarnings("rawtypes") // as the library has it
        private final Class type;

        private final boolean signed;
        private final Map<Integer, Object> known = new ConcurrentHashMap<>();

        Entries(Class<?> type, boolean signed) {
            this.type = type;
            this.signed = signed;
        }

        @Override
        public Object value(byte[] bytes, int from, int length) {
            int number = (int) whole(bytes, from, length, signed);
            Object value = known.get(number);
            if (value == null) {
                value = made(number);
                if (known.size() < KEPT_VALUES) {
                    known.put(number, value);
                }
            }
            return value;
        }

        @SuppressWarnings("unchecked") // the annotation names an enumeration
        private Object made(int number) {
            return EnumValue.create(type, number);
        }
    }
}
