	.file	"<string>"
	.section	.rodata.cst8,"aM",@progbits,8
	.p2align	3, 0x0
.LCPI0_0:
	.quad	4575657221408423936
	.section	.ltext,"axl",@progbits
	.globl	_ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29
	.p2align	4
	.type	_ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29,@function
_ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29:
	.cfi_startproc
	pushq	%rbp
	.cfi_def_cfa_offset 16
	pushq	%r15
	.cfi_def_cfa_offset 24
	pushq	%r14
	.cfi_def_cfa_offset 32
	pushq	%r13
	.cfi_def_cfa_offset 40
	pushq	%r12
	.cfi_def_cfa_offset 48
	pushq	%rbx
	.cfi_def_cfa_offset 56
	subq	$136, %rsp
	.cfi_def_cfa_offset 192
	.cfi_offset %rbx, -56
	.cfi_offset %r12, -48
	.cfi_offset %r13, -40
	.cfi_offset %r14, -32
	.cfi_offset %r15, -24
	.cfi_offset %rbp, -16
	movq	872(%rsp), %rbp
	movq	360(%rsp), %r12
	movq	288(%rsp), %r13
	movq	232(%rsp), %r15
	movq	664(%rsp), %rbx
	movabsq	$NRT_incref, %r14
	movq	%rdi, 96(%rsp)
	movq	%rdx, %rdi
	movq	%r9, 16(%rsp)
	movq	%r8, 64(%rsp)
	movq	%rcx, 40(%rsp)
	movq	%rsi, 24(%rsp)
	movq	%rdx, 8(%rsp)
	callq	*%r14
	movq	%r15, %rdi
	callq	*%r14
	movq	%r13, %rdi
	movq	656(%rsp), %r13
	callq	*%r14
	movq	%r12, %rdi
	callq	*%r14
	movq	416(%rsp), %rdi
	callq	*%r14
	movq	472(%rsp), %rdi
	callq	*%r14
	movq	544(%rsp), %rdi
	callq	*%r14
	movq	600(%rsp), %rdi
	callq	*%r14
	movq	680(%rsp), %rdi
	callq	*%r14
	movq	752(%rsp), %rdi
	callq	*%r14
	movq	824(%rsp), %rdi
	callq	*%r14
	movq	864(%rsp), %rcx
	movq	%rbx, %rax
	imulq	%r13, %rax
	leaq	15(%rbp), %r15
	andq	$-8, %r15
	movq	%r15, %r12
	addq	%rax, %rbx
	movq	%rax, 80(%rsp)
	cmpq	%rbx, %rcx
	cmovlq	%rcx, %rbx
	movq	%rbx, 32(%rsp)
	subq	%rax, %rbx
	imulq	%rbx, %r12
	testq	%r12, %r12
	js	.LBB0_62
	movabsq	$1152921504606846976, %rax
	decq	%rax
	cmpq	%rax, %r12
	ja	.LBB0_63
	leaq	(,%r12,8), %r14
	movabsq	$NRT_MemInfo_alloc_aligned, %rax
	movl	$32, %esi
	movq	%r14, %rdi
	callq	*%rax
	testq	%rax, %rax
	je	.LBB0_64
	movq	584(%rsp), %rdi
	movq	576(%rsp), %rcx
	movq	24(%rax), %r11
	movabsq	$.LCPI0_0, %rsi
	movq	%rbx, 72(%rsp)
	testq	%r12, %r12
	je	.LBB0_12
	cmpq	$32, %r12
	jae	.LBB0_6
	xorl	%edx, %edx
	jmp	.LBB0_10
.LBB0_6:
	vpbroadcastq	(%rsi), %zmm0
	movabsq	$9223372036854775776, %rdx
	addq	$-224, %rdx
	andq	%rdx, %r14
	xorl	%edx, %edx
	.p2align	4
.LBB0_7:
	vmovdqu64	%zmm0, (%r11,%rdx)
	vmovdqu64	%zmm0, 64(%r11,%rdx)
	vmovdqu64	%zmm0, 128(%r11,%rdx)
	vmovdqu64	%zmm0, 192(%r11,%rdx)
	addq	$256, %rdx
	cmpq	%rdx, %r14
	jne	.LBB0_7
	movabsq	$1152921504606846976, %rdx
	addq	$-32, %rdx
	andq	%r12, %rdx
	cmpq	%rdx, %r12
	je	.LBB0_12
	testb	$24, %r12b
	je	.LBB0_60
.LBB0_10:
	vpbroadcastq	(%rsi), %ymm0
	.p2align	4
.LBB0_11:
	vmovdqu	%ymm0, (%r11,%rdx,8)
	addq	$4, %rdx
	cmpq	%rdx, %r12
	jne	.LBB0_11
.LBB0_12:
	movq	%r13, %rdx
	sarq	$63, %rdx
	leaq	(%rcx,%r13,8), %rcx
	movq	%r11, 48(%rsp)
	andq	%rdi, %rdx
	movq	(%rcx,%rdx,8), %r14
	xorl	%edx, %edx
	cmpq	$-1, %r13
	cmovlq	%rdi, %rdx
	movq	8(%rcx,%rdx,8), %r13
	subq	%r14, %r13
	testq	%r13, %r13
	jle	.LBB0_16
	movq	32(%rsp), %rcx
	incq	%r13
	decq	%rcx
	movq	%rcx, 56(%rsp)
	.p2align	4
.LBB0_14:
	movq	%r14, %rcx
	sarq	$63, %rcx
	andq	640(%rsp), %rcx
	movq	632(%rsp), %rdx
	movq	64(%rsp), %r8
	movq	16(%rsp), %r9
	leaq	128(%rsp), %rdi
	leaq	120(%rsp), %rsi
	leaq	(%rdx,%rcx,4), %rcx
	movq	8(%rsp), %rdx
	movl	(%rcx,%r14,4), %r10d
	movq	40(%rsp), %rcx
	pushq	864(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	%rbp
	.cfi_adjust_cfa_offset 8
	pushq	%r15
	.cfi_adjust_cfa_offset 8
	pushq	$8
	.cfi_adjust_cfa_offset 8
	pushq	%r12
	.cfi_adjust_cfa_offset 8
	pushq	%r11
	.cfi_adjust_cfa_offset 8
	pushq	$8
	.cfi_adjust_cfa_offset 8
	pushq	%r12
	.cfi_adjust_cfa_offset 8
	pushq	$0
	.cfi_adjust_cfa_offset 8
	movq	%rax, %rbx
	pushq	%rax
	.cfi_adjust_cfa_offset 8
	pushq	752(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	144(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	176(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	%r10
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	648(%rsp)
	.cfi_adjust_cfa_offset 8
	movabsq	$_ZN8__main__10draw_pieceB2v7B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i8UniTupleIxLi2EEx5ArrayIyLi1E1C7mutable7alignedExxx, %rax
	vzeroupper
	callq	*%rax
	addq	$464, %rsp
	.cfi_adjust_cfa_offset -464
	testl	%eax, %eax
	jne	.LBB0_58
	movq	48(%rsp), %r11
	incq	%r14
	decq	%r13
	movq	%rbx, %rax
	cmpq	$1, %r13
	jg	.LBB0_14
.LBB0_16:
	movq	8(%rsp), %rdi
	movabsq	$NRT_decref, %rbx
	movq	%rax, 88(%rsp)
	vzeroupper
	callq	*%rbx
	movq	232(%rsp), %rdi
	callq	*%rbx
	movq	288(%rsp), %rdi
	callq	*%rbx
	movq	360(%rsp), %rdi
	callq	*%rbx
	movq	416(%rsp), %rdi
	callq	*%rbx
	movq	472(%rsp), %rdi
	callq	*%rbx
	movq	544(%rsp), %rdi
	callq	*%rbx
	movq	600(%rsp), %rdi
	callq	*%rbx
	movq	72(%rsp), %r8
	movq	80(%rsp), %r12
	testq	%r8, %r8
	setle	%al
	testq	%rbp, %rbp
	setle	%cl
	orb	%al, %cl
	jne	.LBB0_57
	movq	32(%rsp), %rcx
	leaq	15(%rbp), %rdi
	movq	%r12, %rax
	notq	%rax
	movq	48(%rsp), %r15
	movq	712(%rsp), %r10
	movq	728(%rsp), %rdx
	movq	856(%rsp), %rsi
	movabsq	$9223372036854775776, %r9
	movabsq	$4575657221408423936, %r13
	vpcmpeqd	%ymm1, %ymm1, %ymm1
	shrq	$3, %rdi
	addq	%rax, %rcx
	imulq	%rdi, %rcx
	shlq	$6, %rdi
	movq	%rdi, 64(%rsp)
	movabsq	$.LCPI0_0, %rdi
	vpbroadcastq	(%rdi), %zmm0
	shlq	$6, %rcx
	addq	%r15, %rcx
	leaq	(%rcx,%rbp,8), %rax
	movq	%rbp, %rcx
	andq	%r9, %rcx
	orq	$24, %r9
	andq	%rbp, %r9
	movq	%rax, 40(%rsp)
	leaq	(%r10,%rbp,4), %rax
	movq	%rax, 56(%rsp)
	leaq	(,%rdx,4), %rax
	leaq	192(%r15), %rdx
	movq	%rax, 16(%rsp)
	movl	%ebp, %eax
	andl	$7, %eax
	movq	%rax, 8(%rsp)
	leaq	96(%r10), %rax
	movq	%rax, 112(%rsp)
	leaq	28(%r10), %rax
	movq	%rax, 32(%rsp)
	leaq	96(%rsi), %rax
	movq	%rax, 104(%rsp)
	leaq	28(%rsi), %rax
	movl	$-1, %esi
	movq	%rax, 24(%rsp)
	jmp	.LBB0_19
	.p2align	4
.LBB0_18:
	movq	64(%rsp), %rax
	movq	72(%rsp), %r8
	incq	%r12
	addq	%rax, %rdx
	addq	%rax, %r15
	subq	$1, %r8
	jbe	.LBB0_57
.LBB0_19:
	movq	%r12, %rbx
	sarq	$63, %rbx
	movq	%r12, %rax
	movq	%r8, 72(%rsp)
	movq	%rax, %rdi
	movq	%rbx, %r12
	andq	720(%rsp), %r12
	addq	%rax, %r12
	cmpq	$8, %rbp
	jb	.LBB0_20
	movq	%r12, %rax
	imulq	728(%rsp), %rax
	movq	712(%rsp), %r8
	leaq	15(%rbp), %r11
	movabsq	$1152921504606846976, %r10
	testq	%r10, %r11
	movq	16(%rsp), %r11
	setne	%r10b
	imulq	%r12, %r11
	leaq	(%r8,%rax,4), %rax
	movq	56(%rsp), %r8
	cmpq	40(%rsp), %rax
	leaq	(%r8,%r11), %r14
	setb	%al
	cmpq	%r14, 48(%rsp)
	setb	%r14b
	andb	%al, %r14b
	orb	%r10b, %r14b
	je	.LBB0_23
.LBB0_20:
	xorl	%r10d, %r10d
.LBB0_32:
	cmpq	$0, 8(%rsp)
	movq	%r10, %r11
	je	.LBB0_35
	movq	16(%rsp), %rax
	movq	8(%rsp), %r14
	movq	%r10, %r11
	imulq	%r12, %rax
	addq	712(%rsp), %rax
	.p2align	4
.LBB0_34:
	movq	(%r15,%r11,8), %r8
	cmpq	%r13, %r8
	cmovel	%esi, %r8d
	decq	%r14
	movl	%r8d, (%rax,%r11,4)
	leaq	1(%r11), %r11
	jne	.LBB0_34
.LBB0_35:
	subq	%rbp, %r10
	cmpq	$-8, %r10
	ja	.LBB0_38
	imulq	16(%rsp), %r12
	addq	32(%rsp), %r12
	.p2align	4
.LBB0_37:
	movq	(%r15,%r11,8), %rax
	cmpq	%r13, %rax
	cmovel	%esi, %eax
	movl	%eax, -28(%r12,%r11,4)
	movq	8(%r15,%r11,8), %rax
	cmpq	%r13, %rax
	cmovel	%esi, %eax
	movl	%eax, -24(%r12,%r11,4)
	movq	16(%r15,%r11,8), %rax
	cmpq	%r13, %rax
	cmovel	%esi, %eax
	movl	%eax, -20(%r12,%r11,4)
	movq	24(%r15,%r11,8), %rax
	cmpq	%r13, %rax
	cmovel	%esi, %eax
	movl	%eax, -16(%r12,%r11,4)
	movq	32(%r15,%r11,8), %rax
	cmpq	%r13, %rax
	cmovel	%esi, %eax
	movl	%eax, -12(%r12,%r11,4)
	movq	40(%r15,%r11,8), %rax
	cmpq	%r13, %rax
	cmovel	%esi, %eax
	movl	%eax, -8(%r12,%r11,4)
	movq	48(%r15,%r11,8), %rax
	cmpq	%r13, %rax
	cmovel	%esi, %eax
	movl	%eax, -4(%r12,%r11,4)
	movq	56(%r15,%r11,8), %rax
	cmpq	%r13, %rax
	cmovel	%esi, %eax
	movl	%eax, (%r12,%r11,4)
	addq	$8, %r11
	cmpq	%r11, %rbp
	jne	.LBB0_37
.LBB0_38:
	andq	864(%rsp), %rbx
	movq	%rdi, %r12
	addq	%rdi, %rbx
	cmpq	$8, %rbp
	jb	.LBB0_39
	movq	856(%rsp), %r11
	leaq	15(%rbp), %r8
	movabsq	$1152921504606846976, %rdi
	leaq	4(,%rbx,4), %r10
	movq	%rbx, %rax
	imulq	%rbp, %rax
	testq	%rdi, %r8
	setne	%r8b
	imulq	%rbp, %r10
	leaq	(%r11,%rax,4), %rax
	addq	%r11, %r10
	cmpq	40(%rsp), %rax
	setb	%al
	cmpq	%r10, 48(%rsp)
	setb	%r10b
	andb	%al, %r10b
	orb	%r8b, %r10b
	je	.LBB0_42
.LBB0_39:
	xorl	%r10d, %r10d
.LBB0_51:
	movq	%r10, %r11
	testb	$7, %bpl
	je	.LBB0_54
	leaq	(,%rbp,4), %rax
	movq	8(%rsp), %r14
	movq	%r10, %r11
	imulq	%rbx, %rax
	addq	856(%rsp), %rax
	.p2align	4
.LBB0_53:
	movl	4(%r15,%r11,8), %r8d
	decq	%r14
	movl	%r8d, (%rax,%r11,4)
	leaq	1(%r11), %r11
	jne	.LBB0_53
.LBB0_54:
	subq	%rbp, %r10
	cmpq	$-8, %r10
	ja	.LBB0_18
	leaq	(,%rbp,4), %rax
	imulq	%rax, %rbx
	addq	24(%rsp), %rbx
	.p2align	4
.LBB0_56:
	movl	4(%r15,%r11,8), %eax
	movl	%eax, -28(%rbx,%r11,4)
	movl	12(%r15,%r11,8), %eax
	movl	%eax, -24(%rbx,%r11,4)
	movl	20(%r15,%r11,8), %eax
	movl	%eax, -20(%rbx,%r11,4)
	movl	28(%r15,%r11,8), %eax
	movl	%eax, -16(%rbx,%r11,4)
	movl	36(%r15,%r11,8), %eax
	movl	%eax, -12(%rbx,%r11,4)
	movl	44(%r15,%r11,8), %eax
	movl	%eax, -8(%rbx,%r11,4)
	movl	52(%r15,%r11,8), %eax
	movl	%eax, -4(%rbx,%r11,4)
	movl	60(%r15,%r11,8), %eax
	movl	%eax, (%rbx,%r11,4)
	addq	$8, %r11
	cmpq	%r11, %rbp
	jne	.LBB0_56
	jmp	.LBB0_18
	.p2align	4
.LBB0_23:
	cmpq	$32, %rbp
	jae	.LBB0_25
	xorl	%eax, %eax
	jmp	.LBB0_29
	.p2align	4
.LBB0_42:
	cmpq	$32, %rbp
	jae	.LBB0_44
	xorl	%eax, %eax
	jmp	.LBB0_48
.LBB0_25:
	movq	112(%rsp), %rax
	leaq	(%rax,%r11), %r10
	xorl	%eax, %eax
	.p2align	4
.LBB0_26:
	vmovdqu64	-192(%rdx,%rax,8), %zmm2
	vmovdqu64	-128(%rdx,%rax,8), %zmm3
	vmovdqu64	-64(%rdx,%rax,8), %zmm4
	vmovdqu64	(%rdx,%rax,8), %zmm5
	vpcmpeqq	%zmm0, %zmm2, %k1
	vpmovqd	%zmm2, %ymm2
	vpcmpeqq	%zmm0, %zmm3, %k2
	vpmovqd	%zmm3, %ymm3
	vpcmpeqq	%zmm0, %zmm4, %k3
	vpmovqd	%zmm4, %ymm4
	vpcmpeqq	%zmm0, %zmm5, %k4
	vpmovqd	%zmm5, %ymm5
	vmovdqa32	%ymm1, %ymm2 {%k1}
	vmovdqa32	%ymm1, %ymm3 {%k2}
	vmovdqu	%ymm2, -96(%r10,%rax,4)
	vmovdqa32	%ymm1, %ymm4 {%k3}
	vmovdqu	%ymm3, -64(%r10,%rax,4)
	vmovdqa32	%ymm1, %ymm5 {%k4}
	vmovdqu	%ymm4, -32(%r10,%rax,4)
	vmovdqu	%ymm5, (%r10,%rax,4)
	addq	$32, %rax
	cmpq	%rax, %rcx
	jne	.LBB0_26
	cmpq	%rcx, %rbp
	je	.LBB0_38
	movq	%rcx, %rax
	movq	%rcx, %r10
	testb	$24, %bpl
	je	.LBB0_32
.LBB0_29:
	addq	712(%rsp), %r11
	.p2align	4
.LBB0_30:
	vmovdqu64	(%r15,%rax,8), %zmm2
	vpcmpeqq	%zmm0, %zmm2, %k1
	vpmovqd	%zmm2, %ymm2
	vmovdqa32	%ymm1, %ymm2 {%k1}
	vmovdqu	%ymm2, (%r11,%rax,4)
	addq	$8, %rax
	cmpq	%rax, %r9
	jne	.LBB0_30
	movq	%r9, %r10
	cmpq	%r9, %rbp
	je	.LBB0_38
	jmp	.LBB0_32
.LBB0_44:
	leaq	(,%rbp,4), %rax
	xorl	%r10d, %r10d
	imulq	%rbx, %rax
	addq	104(%rsp), %rax
	.p2align	4
.LBB0_45:
	vpsrlq	$32, -192(%rdx,%r10,8), %zmm2
	vpsrlq	$32, -128(%rdx,%r10,8), %zmm3
	vpsrlq	$32, -64(%rdx,%r10,8), %zmm4
	vpsrlq	$32, (%rdx,%r10,8), %zmm5
	vpmovqd	%zmm2, -96(%rax,%r10,4)
	vpmovqd	%zmm3, -64(%rax,%r10,4)
	vpmovqd	%zmm4, -32(%rax,%r10,4)
	vpmovqd	%zmm5, (%rax,%r10,4)
	addq	$32, %r10
	cmpq	%r10, %rcx
	jne	.LBB0_45
	cmpq	%rcx, %rbp
	je	.LBB0_18
	movq	%rcx, %rax
	movq	%rcx, %r10
	testb	$24, %bpl
	je	.LBB0_51
.LBB0_48:
	leaq	(,%rbp,4), %r10
	imulq	%rbx, %r10
	addq	856(%rsp), %r10
	.p2align	4
.LBB0_49:
	vpsrlq	$32, (%r15,%rax,8), %zmm2
	vpmovqd	%zmm2, (%r10,%rax,4)
	addq	$8, %rax
	cmpq	%rax, %r9
	jne	.LBB0_49
	movq	%r9, %r10
	cmpq	%r9, %rbp
	je	.LBB0_18
	jmp	.LBB0_51
.LBB0_57:
	movq	680(%rsp), %rdi
	movabsq	$NRT_decref, %rbx
	vzeroupper
	callq	*%rbx
	movq	752(%rsp), %rdi
	callq	*%rbx
	movq	824(%rsp), %rdi
	callq	*%rbx
	movq	88(%rsp), %rdi
	callq	*%rbx
	movq	96(%rsp), %rax
	movq	$0, (%rax)
	xorl	%eax, %eax
	jmp	.LBB0_59
.LBB0_58:
	movq	24(%rsp), %rcx
	movq	$0, (%rcx)
.LBB0_59:
	addq	$136, %rsp
	.cfi_def_cfa_offset 56
	popq	%rbx
	.cfi_def_cfa_offset 48
	popq	%r12
	.cfi_def_cfa_offset 40
	popq	%r13
	.cfi_def_cfa_offset 32
	popq	%r14
	.cfi_def_cfa_offset 24
	popq	%r15
	.cfi_def_cfa_offset 16
	popq	%rbp
	.cfi_def_cfa_offset 8
	retq
.LBB0_60:
	.cfi_def_cfa_offset 192
	movabsq	$4575657221408423936, %rsi
	.p2align	4
.LBB0_61:
	movq	%rsi, (%r11,%rdx,8)
	incq	%rdx
	cmpq	%rdx, %r12
	jne	.LBB0_61
	jmp	.LBB0_12
.LBB0_62:
	movabsq	$.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b, %rax
	jmp	.LBB0_65
.LBB0_63:
	movabsq	$.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57, %rax
	jmp	.LBB0_65
.LBB0_64:
	movabsq	$.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209, %rax
.LBB0_65:
	movq	24(%rsp), %rcx
	movq	%rax, (%rcx)
	movl	$1, %eax
	jmp	.LBB0_59
.Lfunc_end0:
	.size	_ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29, .Lfunc_end0-_ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29
	.cfi_endproc

	.globl	_ZN7cpython8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29
	.p2align	4
	.type	_ZN7cpython8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29,@function
_ZN7cpython8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29:
	.cfi_startproc
	pushq	%rbp
	.cfi_def_cfa_offset 16
	pushq	%r15
	.cfi_def_cfa_offset 24
	pushq	%r14
	.cfi_def_cfa_offset 32
	pushq	%r13
	.cfi_def_cfa_offset 40
	pushq	%r12
	.cfi_def_cfa_offset 48
	pushq	%rbx
	.cfi_def_cfa_offset 56
	subq	$2056, %rsp
	.cfi_def_cfa_offset 2112
	.cfi_offset %rbx, -56
	.cfi_offset %r12, -48
	.cfi_offset %r13, -40
	.cfi_offset %r14, -32
	.cfi_offset %r15, -24
	.cfi_offset %rbp, -16
	leaq	1208(%rsp), %rax
	movq	%rsi, %rdi
	movabsq	$.const.draw_band, %rsi
	movabsq	$PyArg_UnpackTuple, %r10
	leaq	1240(%rsp), %r8
	leaq	1232(%rsp), %r9
	movl	$5, %edx
	movl	$5, %ecx
	xorl	%ebx, %ebx
	movq	%rax, 16(%rsp)
	leaq	1216(%rsp), %rax
	movq	%rax, 8(%rsp)
	leaq	1224(%rsp), %rax
	movq	%rax, (%rsp)
	xorl	%eax, %eax
	callq	*%r10
	vxorps	%xmm0, %xmm0, %xmm0
	vxorps	%xmm1, %xmm1, %xmm1
	vmovups	%ymm0, 1376(%rsp)
	vmovups	%ymm0, 1312(%rsp)
	vmovups	%ymm0, 1248(%rsp)
	vmovups	%ymm0, 1744(%rsp)
	vmovups	%ymm0, 1680(%rsp)
	vmovups	%ymm0, 1400(%rsp)
	vmovups	%zmm1, 1520(%rsp)
	movq	$0, 1584(%rsp)
	vmovups	%ymm0, 1336(%rsp)
	vmovups	%ymm0, 1272(%rsp)
	vmovups	%zmm1, 1440(%rsp)
	movq	$0, 1504(%rsp)
	vmovups	%ymm0, 1768(%rsp)
	vmovups	%ymm0, 1704(%rsp)
	vmovups	%zmm1, 1808(%rsp)
	movq	$0, 1872(%rsp)
	vmovups	%zmm1, 1984(%rsp)
	movq	$0, 2048(%rsp)
	vmovups	%zmm1, 1904(%rsp)
	movq	$0, 1968(%rsp)
	movq	$0, 1200(%rsp)
	movq	$0, 800(%rsp)
	testl	%eax, %eax
	je	.LBB1_39
	movabsq	$_ZN08NumbaEnv8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29, %rax
	cmpq	$0, (%rax)
	je	.LBB1_44
	movq	1240(%rsp), %rbx
	movabsq	$PyTuple_Size, %rax
	movq	%rbx, %rdi
	vzeroupper
	callq	*%rax
	cmpq	$6, %rax
	setne	%bpl
	jne	.LBB1_49
.LBB1_3:
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbx, %rdi
	xorl	%esi, %esi
	callq	*%rax
	movabsq	$NRT_adapt_ndarray_from_python, %rcx
	leaq	1600(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	movq	%rax, %rdi
	vmovups	%zmm0, 1600(%rsp)
	movq	$0, 1664(%rsp)
	vzeroupper
	callq	*%rcx
	movq	1624(%rsp), %r12
	cmpq	$4, %r12
	setne	%cl
	testl	%eax, %eax
	setne	%r14b
	orb	%cl, %r14b
	cmpb	$1, %r14b
	je	.LBB1_50
	testb	%r14b, %r14b
	jne	.LBB1_51
.LBB1_5:
	movq	1632(%rsp), %rcx
	movq	1640(%rsp), %rdx
	movq	1616(%rsp), %rax
	movq	1600(%rsp), %r15
	movq	1608(%rsp), %r13
	movl	$1, %esi
	movq	%rbx, %rdi
	movq	%rcx, 704(%rsp)
	movq	1648(%rsp), %rcx
	movq	%rdx, 1192(%rsp)
	movq	1656(%rsp), %rdx
	movq	%rax, 712(%rsp)
	movabsq	$PyTuple_GetItem, %rax
	movq	%rcx, 1184(%rsp)
	movq	1664(%rsp), %rcx
	movq	%rdx, 1176(%rsp)
	movq	%rcx, 1168(%rsp)
	callq	*%rax
	movq	%rax, %rdi
	leaq	1376(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 1376(%rsp)
	vmovups	%ymm0, 1400(%rsp)
	vzeroupper
	callq	*%rax
	movq	1400(%rsp), %r14
	testl	%eax, %eax
	jne	.LBB1_46
	cmpq	$4, %r14
	jne	.LBB1_46
.LBB1_7:
	movq	1384(%rsp), %rcx
	movq	1392(%rsp), %rdx
	movq	1376(%rsp), %rax
	movl	$2, %esi
	movq	%r14, 1160(%rsp)
	movq	%rbx, %rdi
	movq	%rcx, 1152(%rsp)
	movq	1408(%rsp), %rcx
	movq	%rdx, 1144(%rsp)
	movq	1416(%rsp), %rdx
	movq	%rax, 784(%rsp)
	movabsq	$PyTuple_GetItem, %rax
	movq	%rcx, 1136(%rsp)
	movq	1424(%rsp), %rcx
	movq	%rdx, 1128(%rsp)
	movq	%rcx, 1120(%rsp)
	callq	*%rax
	movq	%rax, %rdi
	leaq	1520(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%zmm0, 1520(%rsp)
	movq	$0, 1584(%rsp)
	vzeroupper
	callq	*%rax
	movq	1544(%rsp), %rcx
	cmpq	$4, %rcx
	movq	%rcx, 1112(%rsp)
	setne	%cl
	testl	%eax, %eax
	setne	%r14b
	orb	%cl, %r14b
	cmpb	$1, %r14b
	je	.LBB1_52
	testb	%r14b, %r14b
	jne	.LBB1_53
.LBB1_9:
	movq	1536(%rsp), %rdx
	movq	1552(%rsp), %rcx
	movq	1528(%rsp), %rax
	movq	1520(%rsp), %r14
	movl	$3, %esi
	movq	%rbx, %rdi
	movq	%rdx, 1096(%rsp)
	movq	%rcx, 1088(%rsp)
	movq	1560(%rsp), %rdx
	movq	1568(%rsp), %rcx
	movq	%rax, 1104(%rsp)
	movabsq	$PyTuple_GetItem, %rax
	movq	%rdx, 1080(%rsp)
	movq	%rcx, 1072(%rsp)
	movq	1576(%rsp), %rdx
	movq	1584(%rsp), %rcx
	movq	%rdx, 1064(%rsp)
	movq	%rcx, 1056(%rsp)
	callq	*%rax
	movq	%rax, %rdi
	leaq	1312(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 1312(%rsp)
	vmovups	%ymm0, 1336(%rsp)
	vzeroupper
	callq	*%rax
	movq	1336(%rsp), %rcx
	movq	%rcx, 1048(%rsp)
	testl	%eax, %eax
	jne	.LBB1_47
	cmpq	$4, %rcx
	jne	.LBB1_47
.LBB1_11:
	movq	1320(%rsp), %rcx
	movq	1328(%rsp), %rdx
	movq	1312(%rsp), %rax
	movl	$4, %esi
	movq	%rbx, %rdi
	movq	%rcx, 1040(%rsp)
	movq	1344(%rsp), %rcx
	movq	%rdx, 1032(%rsp)
	movq	1352(%rsp), %rdx
	movq	%rax, 776(%rsp)
	movabsq	$PyTuple_GetItem, %rax
	movq	%rcx, 1024(%rsp)
	movq	1360(%rsp), %rcx
	movq	%rdx, 1016(%rsp)
	movq	%rcx, 1008(%rsp)
	callq	*%rax
	movq	%rax, %rdi
	leaq	1248(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 1248(%rsp)
	vmovups	%ymm0, 1272(%rsp)
	vzeroupper
	callq	*%rax
	movq	1272(%rsp), %rcx
	movq	%rcx, 1000(%rsp)
	testl	%eax, %eax
	jne	.LBB1_48
	cmpq	$4, %rcx
	jne	.LBB1_48
.LBB1_13:
	movq	1256(%rsp), %rcx
	movq	1264(%rsp), %rdx
	movq	1248(%rsp), %rax
	movl	$5, %esi
	movq	%rbx, %rdi
	movq	%rcx, 992(%rsp)
	movq	1280(%rsp), %rcx
	movq	%rdx, 984(%rsp)
	movq	1288(%rsp), %rdx
	movq	%rax, 768(%rsp)
	movabsq	$PyTuple_GetItem, %rax
	movq	%rcx, 976(%rsp)
	movq	1296(%rsp), %rcx
	movq	%rdx, 968(%rsp)
	movq	%rcx, 960(%rsp)
	callq	*%rax
	movq	%rax, %rdi
	leaq	1440(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%zmm0, 1440(%rsp)
	movq	$0, 1504(%rsp)
	vzeroupper
	callq	*%rax
	cmpq	$4, 1464(%rsp)
	setne	%cl
	testl	%eax, %eax
	setne	%bl
	orb	%cl, %bl
	cmpb	$1, %bl
	je	.LBB1_54
	orb	%bl, %bpl
	jne	.LBB1_55
.LBB1_15:
	movq	1448(%rsp), %rcx
	movq	1456(%rsp), %rdx
	movq	1440(%rsp), %rax
	movq	1232(%rsp), %rbx
	movq	%rcx, 952(%rsp)
	movq	1472(%rsp), %rcx
	movq	%rdx, 944(%rsp)
	movq	1480(%rsp), %rdx
	movq	%rax, 736(%rsp)
	movabsq	$PyTuple_Size, %rax
	movq	%rbx, %rdi
	movq	%rcx, 936(%rsp)
	movq	1488(%rsp), %rcx
	movq	%rdx, 928(%rsp)
	movq	1496(%rsp), %rdx
	movq	%rcx, 920(%rsp)
	movq	1504(%rsp), %rcx
	movq	%rdx, 912(%rsp)
	movq	%rcx, 904(%rsp)
	callq	*%rax
	cmpq	$2, %rax
	setne	%bpl
	jne	.LBB1_57
.LBB1_16:
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbx, %rdi
	xorl	%esi, %esi
	callq	*%rax
	movq	%rax, %rdi
	leaq	1744(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 1744(%rsp)
	vmovups	%ymm0, 1768(%rsp)
	vzeroupper
	callq	*%rax
	testl	%eax, %eax
	jne	.LBB1_56
	cmpq	$8, 1768(%rsp)
	jne	.LBB1_56
.LBB1_18:
	movq	1744(%rsp), %rax
	movq	1776(%rsp), %rdx
	movq	1784(%rsp), %rcx
	movl	$1, %esi
	movq	%rbx, %rdi
	movq	%rax, 728(%rsp)
	movabsq	$PyTuple_GetItem, %rax
	movq	%rdx, 896(%rsp)
	movq	%rcx, 888(%rsp)
	callq	*%rax
	movq	%rax, %rdi
	leaq	1680(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 1680(%rsp)
	vmovups	%ymm0, 1704(%rsp)
	vzeroupper
	callq	*%rax
	cmpq	$4, 1704(%rsp)
	setne	%cl
	testl	%eax, %eax
	setne	%bl
	orb	%cl, %bl
	cmpb	$1, %bl
	je	.LBB1_58
	orb	%bl, %bpl
	jne	.LBB1_65
.LBB1_20:
	movq	1680(%rsp), %rax
	movq	1712(%rsp), %rdx
	movq	1720(%rsp), %rcx
	movq	1224(%rsp), %rbx
	movq	%r14, 752(%rsp)
	movq	%r12, 880(%rsp)
	movq	%r15, 760(%rsp)
	movq	%rax, 720(%rsp)
	movabsq	$PyTuple_Size, %rax
	movq	%rbx, %rdi
	movq	%rdx, 864(%rsp)
	movq	%rcx, 856(%rsp)
	callq	*%rax
	cmpq	$2, %rax
	setne	%r12b
	jne	.LBB1_59
.LBB1_21:
	movabsq	$PyTuple_GetItem, %rax
	movq	%r13, 872(%rsp)
	xorl	%r13d, %r13d
	movq	%rbx, %rdi
	xorl	%esi, %esi
	callq	*%rax
	movabsq	$PyNumber_Long, %rcx
	movq	%rax, %rdi
	callq	*%rcx
	movabsq	$PyLong_AsLongLong, %r15
	movabsq	$Py_DecRef, %rbp
	testq	%rax, %rax
	je	.LBB1_23
	movq	%rax, %rdi
	movq	%rax, %r14
	callq	*%r15
	movq	%r14, %rdi
	movq	%rax, %r13
	callq	*%rbp
.LBB1_23:
	movq	%r13, 848(%rsp)
	movabsq	$PyErr_Occurred, %r13
	movq	%r15, %r14
	callq	*%r13
	testq	%rax, %rax
	jne	.LBB1_60
.LBB1_24:
	movl	$1, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbx, %rdi
	callq	*%rax
	movabsq	$PyNumber_Long, %rbp
	movq	%rax, %rdi
	callq	*%rbp
	movq	%r14, %r15
	testq	%rax, %rax
	je	.LBB1_61
	movq	%rax, %rdi
	movq	%rax, %rbx
	callq	*%r15
	movq	%rbx, %rdi
	movabsq	$Py_DecRef, %rbx
	movq	%rax, 744(%rsp)
	callq	*%rbx
.LBB1_26:
	callq	*%r13
	testq	%rax, %rax
	setne	%al
	orb	%al, %r12b
	jne	.LBB1_64
	movq	1216(%rsp), %rdi
	callq	*%rbp
	testq	%rax, %rax
	je	.LBB1_62
	movq	%rax, %rdi
	movq	%rax, %r14
	callq	*%r15
	movq	%rbx, %rcx
	movq	%r14, %rdi
	movq	%rax, %rbx
	callq	*%rcx
	callq	*%r13
	testq	%rax, %rax
	jne	.LBB1_64
.LBB1_29:
	movq	1208(%rsp), %r12
	movabsq	$PyTuple_Size, %rax
	movq	%rbx, 840(%rsp)
	movq	%r12, %rdi
	callq	*%rax
	cmpq	$3, %rax
	setne	%r15b
	jne	.LBB1_66
.LBB1_30:
	movabsq	$PyTuple_GetItem, %rax
	movq	%r12, %rdi
	xorl	%esi, %esi
	callq	*%rax
	movq	%rax, %rdi
	leaq	1808(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%zmm0, 1808(%rsp)
	movq	$0, 1872(%rsp)
	vzeroupper
	callq	*%rax
	cmpq	$4, 1832(%rsp)
	setne	%cl
	testl	%eax, %eax
	setne	%bl
	orb	%cl, %bl
	cmpb	$1, %bl
	je	.LBB1_67
	testb	%bl, %bl
	jne	.LBB1_68
.LBB1_32:
	movq	1808(%rsp), %rax
	movq	1848(%rsp), %rcx
	movq	1840(%rsp), %rbx
	movq	1856(%rsp), %r13
	movl	$1, %esi
	movq	%r12, %rdi
	movq	%rax, 792(%rsp)
	movabsq	$PyTuple_GetItem, %rax
	movq	%rcx, 832(%rsp)
	callq	*%rax
	movq	%rax, %rdi
	leaq	1984(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%zmm0, 1984(%rsp)
	movq	$0, 2048(%rsp)
	vzeroupper
	callq	*%rax
	cmpq	$4, 2008(%rsp)
	setne	%cl
	testl	%eax, %eax
	setne	%r14b
	orb	%cl, %r14b
	cmpb	$1, %r14b
	je	.LBB1_69
	testb	%r14b, %r14b
	jne	.LBB1_70
.LBB1_34:
	movq	1984(%rsp), %rbp
	movl	$2, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%r12, %rdi
	callq	*%rax
	movq	%rax, %rdi
	leaq	1904(%rsp), %rsi
	movabsq	$NRT_adapt_ndarray_from_python, %rax
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%zmm0, 1904(%rsp)
	movq	$0, 1968(%rsp)
	vzeroupper
	callq	*%rax
	testl	%eax, %eax
	jne	.LBB1_63
	cmpq	$4, 1928(%rsp)
	jne	.LBB1_63
	movq	840(%rsp), %r12
	testb	%r15b, %r15b
	jne	.LBB1_64
	vmovaps	1936(%rsp), %xmm0
	movq	1904(%rsp), %r15
	movq	1952(%rsp), %r14
	movabsq	$PyEval_SaveThread, %rax
	movq	%r15, 816(%rsp)
	vmovaps	%xmm0, 1888(%rsp)
	callq	*%rax
	vmovaps	1888(%rsp), %xmm0
	movq	%rax, 824(%rsp)
	movq	%r14, 680(%rsp)
	leaq	1200(%rsp), %rdi
	leaq	800(%rsp), %rsi
	vmovups	%xmm0, 664(%rsp)
	movq	%r13, 536(%rsp)
	movq	%rbx, 520(%rsp)
	movq	%r12, 480(%rsp)
	movq	%rbp, 808(%rsp)
	movq	%rbp, 560(%rsp)
	movq	%r15, 632(%rsp)
	movq	$4, 304(%rsp)
	movq	848(%rsp), %rcx
	movq	744(%rsp), %rdx
	movq	832(%rsp), %rax
	movq	768(%rsp), %rbp
	movq	776(%rsp), %r12
	movq	752(%rsp), %rbx
	movq	784(%rsp), %r13
	movq	712(%rsp), %r8
	movq	880(%rsp), %r9
	movq	760(%rsp), %r14
	movq	%rcx, 464(%rsp)
	movq	864(%rsp), %rcx
	movq	%rdx, 472(%rsp)
	movq	856(%rsp), %rdx
	movq	%rax, 528(%rsp)
	movabsq	$_ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29, %rax
	movq	%rbp, 224(%rsp)
	movq	%r12, 168(%rsp)
	movq	%rbx, 96(%rsp)
	movq	%r13, 40(%rsp)
	movq	%rcx, 440(%rsp)
	movq	896(%rsp), %rcx
	movq	%rdx, 448(%rsp)
	movq	888(%rsp), %rdx
	movq	%rcx, 384(%rsp)
	movq	912(%rsp), %rcx
	movq	%rdx, 392(%rsp)
	movq	904(%rsp), %rdx
	movq	%rcx, 336(%rsp)
	movq	928(%rsp), %rcx
	movq	%rdx, 344(%rsp)
	movq	920(%rsp), %rdx
	movq	%rcx, 320(%rsp)
	movq	944(%rsp), %rcx
	movq	%rdx, 328(%rsp)
	movq	936(%rsp), %rdx
	movq	%rcx, 296(%rsp)
	movq	960(%rsp), %rcx
	movq	%rdx, 312(%rsp)
	movq	952(%rsp), %rdx
	movq	%rcx, 272(%rsp)
	movq	976(%rsp), %rcx
	movq	%rdx, 288(%rsp)
	movq	968(%rsp), %rdx
	movq	%rcx, 256(%rsp)
	movq	984(%rsp), %rcx
	movq	%rdx, 264(%rsp)
	movq	1000(%rsp), %rdx
	movq	%rcx, 240(%rsp)
	movq	1008(%rsp), %rcx
	movq	%rdx, 248(%rsp)
	movq	992(%rsp), %rdx
	movq	%rcx, 216(%rsp)
	movq	1024(%rsp), %rcx
	movq	%rdx, 232(%rsp)
	movq	1016(%rsp), %rdx
	movq	%rcx, 200(%rsp)
	movq	1032(%rsp), %rcx
	movq	%rdx, 208(%rsp)
	movq	1048(%rsp), %rdx
	movq	%rcx, 184(%rsp)
	movq	1056(%rsp), %rcx
	movq	%rdx, 192(%rsp)
	movq	1040(%rsp), %rdx
	movq	%rcx, 160(%rsp)
	movq	1072(%rsp), %rcx
	movq	%rdx, 176(%rsp)
	movq	1064(%rsp), %rdx
	movq	%rcx, 144(%rsp)
	movq	1088(%rsp), %rcx
	movq	%rdx, 152(%rsp)
	movq	1080(%rsp), %rdx
	movq	%rcx, 128(%rsp)
	movq	1096(%rsp), %rcx
	movq	%rdx, 136(%rsp)
	movq	1112(%rsp), %rdx
	movq	%rcx, 112(%rsp)
	movq	1120(%rsp), %rcx
	movq	%rdx, 120(%rsp)
	movq	1104(%rsp), %rdx
	movq	%rcx, 88(%rsp)
	movq	1136(%rsp), %rcx
	movq	%rdx, 104(%rsp)
	movq	1128(%rsp), %rdx
	movq	%rcx, 72(%rsp)
	movq	1144(%rsp), %rcx
	movq	%rdx, 80(%rsp)
	movq	1160(%rsp), %rdx
	movq	%rcx, 56(%rsp)
	movq	1168(%rsp), %rcx
	movq	%rdx, 64(%rsp)
	movq	1152(%rsp), %rdx
	movq	%rcx, 32(%rsp)
	movq	792(%rsp), %rcx
	movq	%rdx, 48(%rsp)
	movq	1176(%rsp), %rdx
	movq	%rcx, 488(%rsp)
	movq	728(%rsp), %rcx
	movq	%rdx, 24(%rsp)
	movq	720(%rsp), %rdx
	movq	%rcx, 352(%rsp)
	movq	1184(%rsp), %rcx
	movq	%rdx, 408(%rsp)
	movq	736(%rsp), %rdx
	movq	%rcx, 16(%rsp)
	movq	704(%rsp), %rcx
	movq	%rdx, 280(%rsp)
	movq	1192(%rsp), %rdx
	movq	%rcx, (%rsp)
	movq	872(%rsp), %rcx
	movq	%rdx, 8(%rsp)
	movq	%r14, %rdx
	callq	*%rax
	movq	800(%rsp), %rcx
	movq	824(%rsp), %rdi
	movl	%eax, 712(%rsp)
	movabsq	$PyEval_RestoreThread, %rax
	movq	%rcx, 704(%rsp)
	callq	*%rax
	movabsq	$NRT_decref, %r15
	movq	%r14, %rdi
	callq	*%r15
	movq	%r13, %rdi
	callq	*%r15
	movq	%rbx, %rdi
	callq	*%r15
	movq	%r12, %rdi
	callq	*%r15
	movq	%rbp, %rdi
	callq	*%r15
	movq	736(%rsp), %rdi
	callq	*%r15
	movq	728(%rsp), %rdi
	callq	*%r15
	movq	720(%rsp), %rdi
	callq	*%r15
	movq	792(%rsp), %rdi
	callq	*%r15
	movq	808(%rsp), %rdi
	callq	*%r15
	movq	816(%rsp), %rdi
	callq	*%r15
	movl	712(%rsp), %eax
	testl	%eax, %eax
	jne	.LBB1_40
	movabsq	$_Py_NoneStruct, %rbx
	movabsq	$Py_IncRef, %rax
	movq	%rbx, %rdi
	callq	*%rax
.LBB1_39:
	movq	%rbx, %rax
	addq	$2056, %rsp
	.cfi_def_cfa_offset 56
	popq	%rbx
	.cfi_def_cfa_offset 48
	popq	%r12
	.cfi_def_cfa_offset 40
	popq	%r13
	.cfi_def_cfa_offset 32
	popq	%r14
	.cfi_def_cfa_offset 24
	popq	%r15
	.cfi_def_cfa_offset 16
	popq	%rbp
	.cfi_def_cfa_offset 8
	vzeroupper
	retq
.LBB1_40:
	.cfi_def_cfa_offset 2112
	movq	704(%rsp), %rbx
	jle	.LBB1_71
	movabsq	$PyErr_Clear, %rax
	callq	*%rax
	movl	8(%rbx), %esi
	movq	(%rbx), %rdi
	cmpl	$0, 32(%rbx)
	jle	.LBB1_74
	movslq	%esi, %rsi
	movabsq	$PyBytes_FromStringAndSize, %rax
	callq	*%rax
	movq	16(%rbx), %rdi
	movq	%rax, %r14
	callq	*24(%rbx)
	testq	%rax, %rax
	je	.LBB1_81
	movabsq	$numba_runtime_build_excinfo_struct, %rcx
	movq	%r14, %rdi
	movq	%rax, %rsi
	callq	*%rcx
	movabsq	$NRT_Free, %r15
	movq	%rbx, %rdi
	movq	%rax, %r14
	callq	*%r15
	jmp	.LBB1_75
.LBB1_44:
	movabsq	$PyExc_RuntimeError, %rdi
	movabsq	$".const.missing Environment: _ZN08NumbaEnv8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29", %rsi
.LBB1_45:
	movabsq	$PyErr_SetString, %rax
	vzeroupper
	callq	*%rax
	xorl	%ebx, %ebx
	jmp	.LBB1_39
.LBB1_46:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_7
.LBB1_47:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_11
.LBB1_48:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_13
.LBB1_49:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 6 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_3
.LBB1_50:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	testb	%r14b, %r14b
	je	.LBB1_5
.LBB1_51:
	movb	$1, %bpl
	jmp	.LBB1_5
.LBB1_52:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	testb	%r14b, %r14b
	je	.LBB1_9
.LBB1_53:
	movb	$1, %bpl
	jmp	.LBB1_9
.LBB1_54:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	orb	%bl, %bpl
	je	.LBB1_15
	jmp	.LBB1_55
.LBB1_56:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_18
.LBB1_57:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 2 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_16
.LBB1_58:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	orb	%bl, %bpl
	je	.LBB1_20
	jmp	.LBB1_65
.LBB1_59:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 2 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_21
.LBB1_60:
	movb	$1, %r12b
	jmp	.LBB1_24
.LBB1_61:
	movq	$0, 744(%rsp)
	movabsq	$Py_DecRef, %rbx
	jmp	.LBB1_26
.LBB1_62:
	xorl	%ebx, %ebx
	callq	*%r13
	testq	%rax, %rax
	je	.LBB1_29
	jmp	.LBB1_64
.LBB1_63:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
.LBB1_64:
	movq	728(%rsp), %rdi
	movabsq	$NRT_decref, %rbx
	callq	*%rbx
	movq	720(%rsp), %rdi
	callq	*%rbx
	movq	760(%rsp), %r15
	movq	752(%rsp), %r14
.LBB1_65:
	movabsq	$NRT_decref, %rbx
	movq	%r15, %rdi
	callq	*%rbx
	movq	784(%rsp), %rdi
	callq	*%rbx
	movq	%r14, %rdi
	callq	*%rbx
	movq	776(%rsp), %rdi
	callq	*%rbx
	movq	768(%rsp), %rdi
	callq	*%rbx
	movq	736(%rsp), %rdi
	callq	*%rbx
	xorl	%ebx, %ebx
	jmp	.LBB1_39
.LBB1_66:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 3 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_30
.LBB1_67:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	testb	%bl, %bl
	je	.LBB1_32
.LBB1_68:
	movb	$1, %r15b
	jmp	.LBB1_32
.LBB1_69:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	testb	%r14b, %r14b
	je	.LBB1_34
.LBB1_70:
	movb	$1, %r15b
	jmp	.LBB1_34
.LBB1_71:
	cmpl	$-3, %eax
	je	.LBB1_78
	cmpl	$-1, %eax
	jne	.LBB1_79
.LBB1_55:
	xorl	%ebx, %ebx
	jmp	.LBB1_39
.LBB1_74:
	movq	16(%rbx), %rdx
	movabsq	$numba_unpickle, %rax
	callq	*%rax
	movq	%rax, %r14
.LBB1_75:
	testq	%r14, %r14
	je	.LBB1_55
	movabsq	$numba_do_raise, %rax
	movq	%r14, %rdi
.LBB1_77:
	callq	*%rax
	xorl	%ebx, %ebx
	jmp	.LBB1_39
.LBB1_78:
	movabsq	$PyExc_StopIteration, %rdi
	movabsq	$PyErr_SetNone, %rax
	jmp	.LBB1_77
.LBB1_79:
	movabsq	$PyExc_SystemError, %rdi
	movabsq	$".const.unknown error when calling native function", %rsi
	jmp	.LBB1_45
.LBB1_81:
	movabsq	$PyExc_RuntimeError, %rdi
	movabsq	$".const.Error creating Python tuple from runtime exception arguments", %rsi
	jmp	.LBB1_45
.Lfunc_end1:
	.size	_ZN7cpython8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29, .Lfunc_end1-_ZN7cpython8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29
	.cfi_endproc

	.globl	cfunc._ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29
	.p2align	4
	.type	cfunc._ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29,@function
cfunc._ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29:
	.cfi_startproc
	pushq	%rbp
	.cfi_def_cfa_offset 16
	pushq	%r15
	.cfi_def_cfa_offset 24
	pushq	%r14
	.cfi_def_cfa_offset 32
	pushq	%rbx
	.cfi_def_cfa_offset 40
	subq	$728, %rsp
	.cfi_def_cfa_offset 768
	.cfi_offset %rbx, -40
	.cfi_offset %r14, -32
	.cfi_offset %r15, -24
	.cfi_offset %rbp, -16
	vmovaps	1136(%rsp), %xmm6
	vmovups	1192(%rsp), %xmm7
	vmovups	1216(%rsp), %ymm8
	vmovups	1272(%rsp), %xmm9
	vmovups	1416(%rsp), %xmm10
	vmovups	768(%rsp), %zmm0
	vmovups	832(%rsp), %zmm1
	vmovups	896(%rsp), %zmm2
	vmovups	960(%rsp), %zmm3
	vmovups	1024(%rsp), %zmm4
	vmovaps	1088(%rsp), %xmm5
	movq	%rcx, %r10
	movq	%rdx, %rax
	movq	%rsi, %rcx
	movq	%rdi, %rdx
	movq	1432(%rsp), %r15
	movq	1104(%rsp), %rsi
	movq	1160(%rsp), %rdi
	movq	1288(%rsp), %r11
	movq	1312(%rsp), %rbx
	movq	1384(%rsp), %r14
	movq	$0, 720(%rsp)
	movq	$0, 712(%rsp)
	movq	%r15, 680(%rsp)
	vmovups	%xmm10, 664(%rsp)
	movq	%r11, 536(%rsp)
	movq	%r14, 632(%rsp)
	movq	%rbx, 560(%rsp)
	vmovups	%xmm9, 520(%rsp)
	vmovups	%ymm8, 464(%rsp)
	vmovups	%xmm7, 440(%rsp)
	movq	%rdi, 408(%rsp)
	vmovups	%xmm6, 384(%rsp)
	movq	%rsi, 352(%rsp)
	movabsq	$_ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29, %r11
	leaq	720(%rsp), %rdi
	leaq	712(%rsp), %rsi
	vmovups	%xmm5, 336(%rsp)
	vmovups	%zmm4, 272(%rsp)
	vmovups	%zmm3, 208(%rsp)
	vmovups	%zmm2, 144(%rsp)
	vmovups	%zmm1, 80(%rsp)
	vmovups	%zmm0, 16(%rsp)
	movq	%r9, 8(%rsp)
	movq	%r8, (%rsp)
	movq	%rax, %r8
	movq	%r10, %r9
	vzeroupper
	callq	*%r11
	movl	%eax, %ecx
	movq	712(%rsp), %rbx
	movq	720(%rsp), %rax
	movl	$0, 708(%rsp)
	testl	%ecx, %ecx
	jne	.LBB2_1
.LBB2_8:
	addq	$728, %rsp
	.cfi_def_cfa_offset 40
	popq	%rbx
	.cfi_def_cfa_offset 32
	popq	%r14
	.cfi_def_cfa_offset 24
	popq	%r15
	.cfi_def_cfa_offset 16
	popq	%rbp
	.cfi_def_cfa_offset 8
	retq
.LBB2_1:
	.cfi_def_cfa_offset 768
	movabsq	$numba_gil_ensure, %r14
	leaq	708(%rsp), %rdi
	movq	%rax, %r15
	movl	%ecx, %ebp
	callq	*%r14
	testl	%ebp, %ebp
	jle	.LBB2_9
	movabsq	$PyErr_Clear, %rax
	callq	*%rax
	movl	8(%rbx), %esi
	movq	(%rbx), %rdi
	cmpl	$0, 32(%rbx)
	jle	.LBB2_12
	movslq	%esi, %rsi
	movabsq	$PyBytes_FromStringAndSize, %rax
	callq	*%rax
	movq	16(%rbx), %rdi
	movq	%rax, %r14
	callq	*24(%rbx)
	testq	%rax, %rax
	je	.LBB2_4
	movabsq	$numba_runtime_build_excinfo_struct, %rcx
	movq	%r14, %rdi
	movq	%rax, %rsi
	callq	*%rcx
	movabsq	$NRT_Free, %rbp
	movq	%rbx, %rdi
	movq	%rax, %r14
	callq	*%rbp
	jmp	.LBB2_13
.LBB2_9:
	movl	%ebp, %eax
	cmpl	$-3, %ebp
	je	.LBB2_5
	cmpl	$-1, %eax
	je	.LBB2_7
	movabsq	$PyExc_SystemError, %rdi
	movabsq	$".const.unknown error when calling native function.2", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	jmp	.LBB2_7
.LBB2_12:
	movq	16(%rbx), %rdx
	movabsq	$numba_unpickle, %rax
	callq	*%rax
	movq	%rax, %r14
.LBB2_13:
	testq	%r14, %r14
	je	.LBB2_7
	movabsq	$numba_do_raise, %rax
	movq	%r14, %rdi
.LBB2_6:
	callq	*%rax
.LBB2_7:
	movabsq	$".const.<numba.core.cpu.CPUContext>", %rdi
	movabsq	$PyUnicode_FromString, %rax
	callq	*%rax
	movabsq	$PyErr_WriteUnraisable, %r14
	movq	%rax, %rbx
	movq	%rbx, %rdi
	callq	*%r14
	movabsq	$Py_DecRef, %rax
	movq	%rbx, %rdi
	callq	*%rax
	movabsq	$numba_gil_release, %rax
	leaq	708(%rsp), %rdi
	callq	*%rax
	movq	%r15, %rax
	jmp	.LBB2_8
.LBB2_5:
	movabsq	$PyExc_StopIteration, %rdi
	movabsq	$PyErr_SetNone, %rax
	jmp	.LBB2_6
.LBB2_4:
	movabsq	$PyExc_RuntimeError, %rdi
	movabsq	$".const.Error creating Python tuple from runtime exception arguments.1", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	xorl	%eax, %eax
	jmp	.LBB2_8
.Lfunc_end2:
	.size	cfunc._ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29, .Lfunc_end2-cfunc._ZN8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29
	.cfi_endproc

	.section	.rodata.cst8,"aM",@progbits,8
	.p2align	3, 0x0
.LCPI3_0:
	.quad	0x3ff0000000000000
.LCPI3_2:
	.quad	4575657221408423936
.LCPI3_3:
	.quad	8
.LCPI3_4:
	.quad	0xbff0000000000000
.LCPI3_5:
	.quad	0x8000000000000000
	.section	.rodata,"a",@progbits
	.p2align	6, 0x0
.LCPI3_1:
	.quad	0
	.quad	1
	.quad	2
	.quad	3
	.quad	4
	.quad	5
	.quad	6
	.quad	7
	.section	.ltext,"axl",@progbits
	.weak	_ZN8__main__10draw_pieceB2v7B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i8UniTupleIxLi2EEx5ArrayIyLi1E1C7mutable7alignedExxx
	.p2align	4
	.type	_ZN8__main__10draw_pieceB2v7B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i8UniTupleIxLi2EEx5ArrayIyLi1E1C7mutable7alignedExxx,@function
_ZN8__main__10draw_pieceB2v7B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i8UniTupleIxLi2EEx5ArrayIyLi1E1C7mutable7alignedExxx:
	.cfi_startproc
	pushq	%rbp
	.cfi_def_cfa_offset 16
	pushq	%r15
	.cfi_def_cfa_offset 24
	pushq	%r14
	.cfi_def_cfa_offset 32
	pushq	%r13
	.cfi_def_cfa_offset 40
	pushq	%r12
	.cfi_def_cfa_offset 48
	pushq	%rbx
	.cfi_def_cfa_offset 56
	subq	$136, %rsp
	.cfi_def_cfa_offset 192
	.cfi_offset %rbx, -56
	.cfi_offset %r12, -48
	.cfi_offset %r13, -40
	.cfi_offset %r14, -32
	.cfi_offset %r15, -24
	.cfi_offset %rbp, -16
	movslq	544(%rsp), %rdx
	movq	192(%rsp), %r8
	movq	328(%rsp), %rcx
	movq	336(%rsp), %rsi
	movq	%rdi, 128(%rsp)
	movq	320(%rsp), %rax
	movq	%rdx, %r9
	sarq	$63, %r9
	andq	200(%rsp), %r9
	movq	%rdx, -72(%rsp)
	addq	%rdx, %r9
	imulq	208(%rsp), %r9
	movslq	(%r8,%r9,4), %r10
	movslq	4(%r8,%r9,4), %r11
	movslq	8(%r8,%r9,4), %r9
	movq	%r10, %rdx
	movq	%r11, %rdi
	sarq	$63, %rdx
	sarq	$63, %rdi
	movq	%r9, %r8
	sarq	$63, %r8
	movq	%r11, 120(%rsp)
	movq	%r9, 16(%rsp)
	movq	%r10, -32(%rsp)
	movq	%rdx, -48(%rsp)
	andq	%rcx, %rdx
	movq	%rdi, 104(%rsp)
	andq	%rcx, %rdi
	andq	%r8, %rcx
	movq	%r8, -16(%rsp)
	addq	%r10, %rdx
	addq	%r11, %rdi
	addq	%r9, %rcx
	imulq	%rsi, %rdi
	imulq	%rsi, %rdx
	imulq	%rsi, %rcx
	movslq	(%rax,%rdx,4), %rbx
	movslq	(%rax,%rdi,4), %r13
	movslq	(%rax,%rcx,4), %r12
	movslq	4(%rax,%rdi,4), %rbp
	movslq	4(%rax,%rcx,4), %r9
	movq	%r13, %r11
	subq	%rbx, %r11
	movq	%rbx, %r8
	movq	%rbx, %rsi
	movq	%rbp, %r10
	movq	%rbp, 80(%rsp)
	movq	%r12, %r15
	movq	%r13, 96(%rsp)
	movq	%rbx, %rcx
	movq	%r9, 48(%rsp)
	movq	%rbx, -96(%rsp)
	movq	%r12, 72(%rsp)
	cmovlq	%r13, %r8
	cmovgq	%r13, %rsi
	cmpq	%r8, %r12
	cmovlq	%r12, %r8
	cmpq	%rsi, %r12
	movq	%r8, 64(%rsp)
	movq	640(%rsp), %r8
	cmovgq	%r12, %rsi
	sarq	$8, %rsi
	decq	%r8
	cmpq	%rsi, %r8
	cmovgeq	%rsi, %r8
	movq	%r8, (%rsp)
	movslq	4(%rax,%rdx,4), %r8
	movq	648(%rsp), %rdx
	subq	%r8, %r10
	movq	%r8, %r14
	movq	%r8, %rsi
	movq	%r8, 88(%rsp)
	cmovlq	%rbp, %r14
	cmovgq	%rbp, %rsi
	movq	%r10, %rdi
	cmpq	%r14, %r9
	cmovlq	%r9, %r14
	negq	%rdi
	negq	%r14
	sarq	$8, %r14
	negq	%r14
	cmpq	%rsi, %r9
	cmovgq	%r9, %rsi
	decq	%rdx
	sarq	$8, %rsi
	cmpq	%rsi, %rdx
	cmovgeq	%rsi, %rdx
	movq	%r12, %rsi
	subq	%rbx, %rsi
	imulq	%rdi, %rsi
	movq	%r9, %rdi
	subq	%r8, %rdi
	imulq	%r11, %rdi
	addq	%rdi, %rsi
	xorl	%edi, %edi
	testq	%rsi, %rsi
	movq	%r9, %rsi
	setg	%dil
	subq	%rbp, %rsi
	movq	568(%rsp), %rbp
	subq	%r13, %r15
	leaq	-1(%rdi,%rdi), %rdi
	imulq	%rdi, %rsi
	imulq	%rdi, %r15
	movq	%rsi, %rax
	imulq	%rbp, %rax
	movq	%r15, 56(%rsp)
	negq	%rax
	setb	%r13b
	subq	%r12, %rcx
	imulq	%rbp, %r15
	movq	%rax, -56(%rsp)
	movl	%r13d, -100(%rsp)
	movq	%r8, %r13
	subq	%r9, %r13
	imulq	%rdi, %rcx
	imulq	%rdi, %r13
	movq	%rcx, %rbx
	movq	%r13, %r8
	imulq	%rbp, %r8
	negq	%r8
	setb	%r9b
	imulq	%rdi, %r10
	imulq	%rdi, %r11
	imulq	%rbp, %rbx
	movl	%r9d, -104(%rsp)
	movq	%r10, %rdi
	imulq	%rbp, %rdi
	movq	%r10, 40(%rsp)
	movq	%r11, 112(%rsp)
	negq	%rdi
	setb	%r10b
	imulq	%r11, %rbp
	testq	%rax, %rax
	movq	%rdi, -64(%rsp)
	setg	%al
	testq	%r15, %r15
	movl	%r10d, -120(%rsp)
	movl	%eax, -124(%rsp)
	setle	%al
	testq	%r8, %r8
	movl	%eax, -112(%rsp)
	setg	%al
	testq	%rbx, %rbx
	movl	%eax, -108(%rsp)
	setle	%al
	testq	%rdi, %rdi
	movq	552(%rsp), %rdi
	setg	%r12b
	testq	%rbp, %rbp
	movl	%eax, -116(%rsp)
	setle	%r10b
	cmpq	%rdi, %r14
	cmovleq	%rdi, %r14
	movq	560(%rsp), %rdi
	movq	%r14, %rax
	sarq	$63, %rax
	andnq	%r14, %rax, %rax
	movabsq	$9223372036854775807, %r14
	cmpq	%rdx, %rdi
	cmovlq	%rdi, %rdx
	subq	%rax, %rdx
	cmpq	%r14, %rdx
	jae	.LBB3_36
	movq	400(%rsp), %r9
	movq	-48(%rsp), %rdi
	movq	%r8, %r11
	movq	392(%rsp), %r8
	imulq	96(%rsp), %rsi
	imulq	72(%rsp), %r13
	imulq	48(%rsp), %rcx
	vxorpd	%xmm15, %xmm15, %xmm15
	andq	%r9, %rdi
	leaq	(%r8,%rdi,4), %r14
	movq	-32(%rsp), %rdi
	subq	%rcx, %r13
	movq	112(%rsp), %rcx
	imulq	88(%rsp), %rcx
	vmovss	(%r14,%rdi,4), %xmm9
	movq	104(%rsp), %rdi
	andq	%r9, %rdi
	leaq	(%r8,%rdi,4), %r14
	movq	56(%rsp), %r8
	movq	120(%rsp), %rdi
	imulq	80(%rsp), %r8
	vmovss	(%r14,%rdi,4), %xmm10
	movq	64(%rsp), %rdi
	subq	%r8, %rsi
	vcvtsi2sd	%rsi, %xmm14, %xmm0
	movq	40(%rsp), %rsi
	vcvtsi2sdq	-56(%rsp), %xmm14, %xmm6
	vcvtsi2sdq	-64(%rsp), %xmm14, %xmm19
	imulq	-96(%rsp), %rsi
	negq	%rdi
	sarq	$8, %rdi
	negq	%rdi
	movq	%rdi, %r14
	sarq	$63, %r14
	vcvtss2sd	%xmm9, %xmm9, %xmm24
	vcvtsi2sd	%r13, %xmm14, %xmm2
	vcvtsi2sd	%rbx, %xmm14, %xmm3
	movq	608(%rsp), %rbx
	vcvtsi2sd	%r15, %xmm14, %xmm1
	vcvtsi2sd	%rbp, %xmm14, %xmm5
	vcvtsi2sd	%r11, %xmm14, %xmm7
	vcvtss2sd	%xmm10, %xmm10, %xmm16
	leaq	1(%rdx), %r15
	andnq	%rdi, %r14, %rdi
	movq	%rdi, %r8
	movq	16(%rsp), %rdi
	movq	%r8, %r14
	subq	%rcx, %rsi
	movl	-100(%rsp), %ecx
	vaddsd	%xmm2, %xmm0, %xmm8
	vcvtsi2sd	%rsi, %xmm14, %xmm4
	movq	392(%rsp), %rsi
	kmovd	%ecx, %k3
	movl	-112(%rsp), %ecx
	vaddsd	%xmm4, %xmm8, %xmm27
	kmovd	%ecx, %k2
	movl	-124(%rsp), %ecx
	kmovd	%ecx, %k4
	movl	-104(%rsp), %ecx
	kmovd	%ecx, %k5
	movl	-116(%rsp), %ecx
	kmovd	%ecx, %k6
	movl	-108(%rsp), %ecx
	kmovd	%ecx, %k7
	movl	-120(%rsp), %ecx
	kmovd	%ecx, %k1
	movq	-16(%rsp), %rcx
	andq	400(%rsp), %rcx
	kmovw	%k1, -96(%rsp)
	kmovd	%r10d, %k1
	movabsq	$.LCPI3_0, %r10
	vmovsd	(%r10), %xmm13
	leaq	(%rsi,%rcx,4), %rsi
	movq	632(%rsp), %rcx
	vmovss	(%rsi,%rdi,4), %xmm9
	movq	(%rsp), %rsi
	vmovsd	%xmm13, %xmm13, %xmm14 {%k1} {z}
	kmovw	-96(%rsp), %k1
	vmovsd	%xmm13, %xmm13, %xmm11 {%k2} {z}
	vmovsd	%xmm13, %xmm13, %xmm12 {%k6} {z}
	kmovd	%r12d, %k2
	vmovsd	%xmm13, %xmm11, %xmm11 {%k3}
	vmovsd	%xmm13, %xmm12, %xmm12 {%k5}
	vmovsd	%xmm15, %xmm11, %xmm11 {%k4}
	vmovsd	%xmm15, %xmm12, %xmm12 {%k7}
	movq	%rsi, %rdi
	subq	%r8, %rdi
	vmovsd	%xmm13, %xmm14, %xmm14 {%k1}
	vcvtss2sd	%xmm9, %xmm9, %xmm26
	vmovsd	%xmm15, %xmm14, %xmm14 {%k2}
	cmpq	$999, %rdi
	jle	.LBB3_2
	movabsq	$.LCPI3_4, %r13
	vcvtsi2sd	%r14, %xmm31, %xmm18
	movq	-72(%rsp), %rdx
	movabsq	$.LCPI3_5, %rdi
	vbroadcastsd	%xmm6, %zmm15
	vbroadcastsd	%xmm7, %zmm17
	shlq	$3, %rcx
	vcvtsi2sd	%rsi, %xmm31, %xmm20
	vmovapd	%xmm6, 16(%rsp)
	vsubsd	%xmm11, %xmm0, %xmm9
	vsubsd	%xmm12, %xmm2, %xmm10
	vsubsd	%xmm14, %xmm4, %xmm13
	vbroadcastsd	%xmm12, %zmm22
	vbroadcastsd	%xmm14, %zmm23
	vbroadcastsd	%xmm24, %zmm24
	vbroadcastsd	%xmm16, %zmm25
	vbroadcastsd	%xmm26, %zmm26
	vbroadcastsd	%xmm27, %zmm27
	movabsq	$.LCPI3_1, %rsi
	movabsq	$.LCPI3_2, %r14
	movabsq	$.LCPI3_3, %r12
	vmovapd	%xmm7, (%rsp)
	xorl	%r9d, %r9d
	vxorpd	%xmm29, %xmm29, %xmm29
	vaddsd	(%r13), %xmm18, %xmm8
	vmovddup	(%rdi), %xmm21
	vpbroadcastq	%rdx, %zmm28
	movq	%rax, %rdx
	subq	552(%rsp), %rdx
	vxorpd	%xmm21, %xmm15, %xmm6
	imulq	%rcx, %rdx
	vmovapd	%xmm6, -96(%rsp)
	vxorpd	%xmm21, %xmm17, %xmm6
	vmovapd	%xmm8, -16(%rsp)
	vmovapd	%xmm19, %xmm8
	vbroadcastsd	%xmm19, %zmm19
	vmovapd	%xmm6, -32(%rsp)
	vxorpd	%xmm21, %xmm19, %xmm6
	vbroadcastsd	%xmm11, %zmm21
	addq	%rdx, %rbx
	vmovapd	%xmm6, -48(%rsp)
	jmp	.LBB3_16
	.p2align	4
.LBB3_35:
	incq	%rax
	addq	%rcx, %rbx
	cmpq	$1, %r15
	leaq	-1(%r15), %r15
	jbe	.LBB3_36
.LBB3_16:
	vcvtsi2sd	%rax, %xmm0, %xmm14
	cmpq	$0, -56(%rsp)
	vmulsd	%xmm14, %xmm1, %xmm31
	vaddsd	%xmm31, %xmm9, %xmm11
	jle	.LBB3_17
	vdivsd	16(%rsp), %xmm11, %xmm11
	vmovapd	%xmm20, %xmm12
	vroundsd	$9, %xmm11, %xmm11, %xmm11
	vxorpd	(%rdi){1to2}, %xmm11, %xmm11
	vmaxsd	%xmm18, %xmm11, %xmm11
	vmulsd	%xmm14, %xmm3, %xmm16
	vaddsd	%xmm16, %xmm10, %xmm30
	testq	%r11, %r11
	jle	.LBB3_23
.LBB3_25:
	vdivsd	(%rsp), %xmm30, %xmm6
	vroundsd	$9, %xmm6, %xmm6, %xmm6
	vxorpd	(%rdi){1to2}, %xmm6, %xmm6
	vmaxsd	%xmm11, %xmm6, %xmm11
	vmulsd	%xmm5, %xmm14, %xmm14
	cmpq	$0, -64(%rsp)
	vaddsd	%xmm14, %xmm13, %xmm30
	jg	.LBB3_30
	jmp	.LBB3_28
	.p2align	4
.LBB3_17:
	js	.LBB3_20
	vmovapd	-16(%rsp), %xmm12
	vxorpd	%xmm6, %xmm6, %xmm6
	vcmplesd	%xmm11, %xmm6, %k1
	vmovsd	%xmm20, %xmm12, %xmm12 {%k1}
	jmp	.LBB3_21
.LBB3_20:
	vdivsd	-96(%rsp), %xmm11, %xmm11
	vroundsd	$9, %xmm11, %xmm11, %xmm11
	vminsd	%xmm20, %xmm11, %xmm12
.LBB3_21:
	vmovapd	%xmm18, %xmm11
	vmulsd	%xmm14, %xmm3, %xmm16
	vaddsd	%xmm16, %xmm10, %xmm30
	testq	%r11, %r11
	jg	.LBB3_25
.LBB3_23:
	js	.LBB3_26
	vaddsd	(%r13), %xmm11, %xmm6
	vxorpd	%xmm7, %xmm7, %xmm7
	vcmplesd	%xmm30, %xmm7, %k1
	vmovsd	%xmm12, %xmm6, %xmm6 {%k1}
	vmovapd	%xmm6, %xmm12
	vmulsd	%xmm5, %xmm14, %xmm14
	cmpq	$0, -64(%rsp)
	vaddsd	%xmm14, %xmm13, %xmm30
	jle	.LBB3_28
.LBB3_30:
	vdivsd	%xmm8, %xmm30, %xmm6
	vroundsd	$9, %xmm6, %xmm6, %xmm6
	vxorpd	(%rdi){1to2}, %xmm6, %xmm6
	vmaxsd	%xmm11, %xmm6, %xmm11
	jmp	.LBB3_32
.LBB3_26:
	vdivsd	-32(%rsp), %xmm30, %xmm6
	vroundsd	$9, %xmm6, %xmm6, %xmm6
	vminsd	%xmm12, %xmm6, %xmm12
	vmulsd	%xmm5, %xmm14, %xmm14
	cmpq	$0, -64(%rsp)
	vaddsd	%xmm14, %xmm13, %xmm30
	jg	.LBB3_30
	.p2align	4
.LBB3_28:
	js	.LBB3_31
	vaddsd	(%r13), %xmm11, %xmm6
	vxorpd	%xmm7, %xmm7, %xmm7
	vcmplesd	%xmm30, %xmm7, %k1
	vmovsd	%xmm12, %xmm6, %xmm6 {%k1}
	vmovapd	%xmm6, %xmm12
	jmp	.LBB3_32
.LBB3_31:
	vdivsd	-48(%rsp), %xmm30, %xmm6
	vroundsd	$9, %xmm6, %xmm6, %xmm6
	vminsd	%xmm12, %xmm6, %xmm12
	.p2align	4
.LBB3_32:
	vcvttsd2si	%xmm11, %rdx
	vcvttsd2si	%xmm12, %rbp
	subq	%rdx, %rbp
	movq	%rbp, %r8
	andq	$-8, %r8
	addq	$8, %r8
	testq	%rbp, %rbp
	cmovsq	%r9, %r8
	testq	%r8, %r8
	jle	.LBB3_35
	vaddsd	%xmm0, %xmm31, %xmm12
	vmovdqa64	(%rsi), %zmm31
	vaddsd	%xmm4, %xmm14, %xmm6
	vaddsd	%xmm2, %xmm16, %xmm14
	leaq	(%rbx,%rdx,8), %rbp
	vpbroadcastq	%rdx, %zmm11
	xorl	%edx, %edx
	vbroadcastsd	%xmm12, %zmm12
	vbroadcastsd	%xmm14, %zmm14
	vbroadcastsd	%xmm6, %zmm16
	.p2align	4
.LBB3_34:
	vpaddq	%zmm11, %zmm31, %zmm6
	vpaddq	(%r12){1to8}, %zmm31, %zmm31
	vpmovqd	%zmm6, %ymm6
	vcvtdq2pd	%ymm6, %zmm6
	vmulpd	%zmm6, %zmm15, %zmm30
	vmulpd	%zmm6, %zmm17, %zmm7
	vmulpd	%zmm6, %zmm19, %zmm6
	vaddpd	%zmm30, %zmm12, %zmm30
	vaddpd	%zmm7, %zmm14, %zmm7
	vaddpd	%zmm6, %zmm16, %zmm6
	vcmplepd	%zmm30, %zmm21, %k1
	vmulpd	%zmm30, %zmm24, %zmm30
	vcmplepd	%zmm7, %zmm22, %k1 {%k1}
	vmulpd	%zmm7, %zmm25, %zmm7
	vcmplepd	%zmm6, %zmm23, %k1 {%k1}
	vmulpd	%zmm6, %zmm26, %zmm6
	vaddpd	%zmm7, %zmm30, %zmm7
	vpbroadcastq	(%r14), %zmm30
	vaddpd	%zmm7, %zmm6, %zmm6
	vdivpd	%zmm27, %zmm6, %zmm6
	vcmpngtpd	(%r10){1to8}, %zmm6, %k3
	vcvtpd2ps	%zmm6, %ymm7
	vcmpnltpd	%zmm29, %zmm6, %k2
	vpmovzxdq	%ymm7, %zmm6
	vpsllq	$32, %zmm6, %zmm30 {%k3}
	vmovdqa64	%zmm28, %zmm6
	vporq	%zmm30, %zmm28, %zmm6 {%k2}
	vpminuq	(%rbp,%rdx,8), %zmm6, %zmm6
	vmovdqu64	%zmm6, (%rbp,%rdx,8) {%k1}
	addq	$8, %rdx
	cmpq	%rdx, %r8
	jne	.LBB3_34
	jmp	.LBB3_35
.LBB3_2:
	movq	%rdi, %r8
	andq	$-8, %r8
	xorl	%esi, %esi
	addq	$8, %r8
	testq	%rdi, %rdi
	cmovnsq	%r8, %rsi
	testq	%rsi, %rsi
	jle	.LBB3_36
	movq	-72(%rsp), %rdi
	vbroadcastsd	%xmm11, %zmm10
	vbroadcastsd	%xmm12, %zmm11
	vbroadcastsd	%xmm14, %zmm12
	vbroadcastsd	%xmm16, %zmm14
	vbroadcastsd	%xmm6, %zmm6
	vbroadcastsd	%xmm7, %zmm7
	vbroadcastsd	%xmm19, %zmm8
	vbroadcastsd	%xmm24, %zmm13
	vbroadcastsd	%xmm26, %zmm15
	vbroadcastsd	%xmm27, %zmm16
	vpbroadcastq	%r14, %zmm9
	movabsq	$.LCPI3_1, %r9
	movabsq	$.LCPI3_2, %r12
	movabsq	$.LCPI3_3, %r11
	vpbroadcastq	%rdi, %zmm17
	testb	$1, %dl
	jne	.LBB3_4
	vcvtsi2sd	%rax, %xmm31, %xmm18
	movq	%rax, %r8
	subq	552(%rsp), %r8
	vbroadcastsd	(%r10), %zmm23
	vmovdqa64	(%r9), %zmm21
	vpbroadcastq	(%r12), %zmm24
	vpbroadcastq	(%r11), %zmm25
	leaq	(%rbx,%r14,8), %rdi
	vxorpd	%xmm22, %xmm22, %xmm22
	vmulsd	%xmm5, %xmm18, %xmm19
	imulq	%rcx, %r8
	vaddsd	%xmm4, %xmm19, %xmm20
	vmulsd	%xmm3, %xmm18, %xmm19
	vmulsd	%xmm1, %xmm18, %xmm18
	leaq	(%rdi,%r8,8), %rdi
	xorl	%r8d, %r8d
	vaddsd	%xmm2, %xmm19, %xmm19
	vaddsd	%xmm0, %xmm18, %xmm18
	vbroadcastsd	%xmm20, %zmm20
	vbroadcastsd	%xmm18, %zmm18
	vbroadcastsd	%xmm19, %zmm19
	.p2align	4
.LBB3_6:
	vpaddq	%zmm9, %zmm21, %zmm26
	vpaddq	%zmm25, %zmm21, %zmm21
	vpmovqd	%zmm26, %ymm26
	vcvtdq2pd	%ymm26, %zmm26
	vmulpd	%zmm26, %zmm6, %zmm27
	vmulpd	%zmm26, %zmm7, %zmm28
	vmulpd	%zmm26, %zmm8, %zmm26
	vaddpd	%zmm27, %zmm18, %zmm27
	vaddpd	%zmm28, %zmm19, %zmm28
	vaddpd	%zmm26, %zmm20, %zmm26
	vcmplepd	%zmm27, %zmm10, %k1
	vmulpd	%zmm27, %zmm13, %zmm27
	vcmplepd	%zmm28, %zmm11, %k1 {%k1}
	vmulpd	%zmm28, %zmm14, %zmm28
	vcmplepd	%zmm26, %zmm12, %k1 {%k1}
	vmulpd	%zmm26, %zmm15, %zmm26
	vaddpd	%zmm28, %zmm27, %zmm27
	vaddpd	%zmm27, %zmm26, %zmm26
	vdivpd	%zmm16, %zmm26, %zmm26
	vcvtpd2ps	%zmm26, %ymm27
	vcmpnltpd	%zmm22, %zmm26, %k2
	vcmpngtpd	%zmm23, %zmm26, %k3
	vpmovzxdq	%ymm27, %zmm26
	vmovdqa64	%zmm24, %zmm27
	vpsllq	$32, %zmm26, %zmm27 {%k3}
	vmovdqa64	%zmm17, %zmm26
	vporq	%zmm27, %zmm17, %zmm26 {%k2}
	vpminuq	(%rdi,%r8,8), %zmm26, %zmm26
	vmovdqu64	%zmm26, (%rdi,%r8,8) {%k1}
	addq	$8, %r8
	cmpq	%r8, %rsi
	jne	.LBB3_6
	testq	%rdx, %rdx
	je	.LBB3_36
	incq	%rax
	jmp	.LBB3_9
.LBB3_4:
	movq	%r15, %rdx
.LBB3_9:
	movq	%rax, %r8
	subq	552(%rsp), %r8
	vbroadcastsd	(%r10), %zmm20
	vmovdqa64	(%r9), %zmm18
	vpbroadcastq	(%r12), %zmm21
	vpbroadcastq	(%r11), %zmm22
	vxorpd	%xmm19, %xmm19, %xmm19
	movq	%r8, %rdi
	incq	%r8
	imulq	%rcx, %rdi
	imulq	%rcx, %r8
	shlq	$4, %rcx
	addq	%r14, %rdi
	addq	%r14, %r8
	leaq	(%rbx,%rdi,8), %rdi
	leaq	(%rbx,%r8,8), %r8
	.p2align	4
.LBB3_10:
	vcvtsi2sd	%rax, %xmm31, %xmm23
	xorl	%r9d, %r9d
	vmovdqa64	%zmm18, %zmm26
	vmulsd	%xmm23, %xmm5, %xmm24
	vaddsd	%xmm4, %xmm24, %xmm25
	vmulsd	%xmm23, %xmm3, %xmm24
	vmulsd	%xmm23, %xmm1, %xmm23
	vaddsd	%xmm2, %xmm24, %xmm24
	vaddsd	%xmm0, %xmm23, %xmm23
	vbroadcastsd	%xmm25, %zmm25
	vbroadcastsd	%xmm23, %zmm23
	vbroadcastsd	%xmm24, %zmm24
	.p2align	4
.LBB3_11:
	vpaddq	%zmm9, %zmm26, %zmm27
	vpaddq	%zmm22, %zmm26, %zmm26
	vpmovqd	%zmm27, %ymm27
	vcvtdq2pd	%ymm27, %zmm27
	vmulpd	%zmm27, %zmm6, %zmm28
	vmulpd	%zmm27, %zmm7, %zmm29
	vmulpd	%zmm27, %zmm8, %zmm27
	vaddpd	%zmm28, %zmm23, %zmm28
	vaddpd	%zmm29, %zmm24, %zmm29
	vaddpd	%zmm27, %zmm25, %zmm27
	vcmplepd	%zmm28, %zmm10, %k1
	vmulpd	%zmm28, %zmm13, %zmm28
	vcmplepd	%zmm29, %zmm11, %k1 {%k1}
	vmulpd	%zmm29, %zmm14, %zmm29
	vcmplepd	%zmm27, %zmm12, %k1 {%k1}
	vmulpd	%zmm27, %zmm15, %zmm27
	vaddpd	%zmm29, %zmm28, %zmm28
	vaddpd	%zmm28, %zmm27, %zmm27
	vdivpd	%zmm16, %zmm27, %zmm27
	vcvtpd2ps	%zmm27, %ymm28
	vcmpnltpd	%zmm19, %zmm27, %k2
	vcmpngtpd	%zmm20, %zmm27, %k3
	vpmovzxdq	%ymm28, %zmm27
	vmovdqa64	%zmm21, %zmm28
	vpsllq	$32, %zmm27, %zmm28 {%k3}
	vmovdqa64	%zmm17, %zmm27
	vporq	%zmm28, %zmm17, %zmm27 {%k2}
	vpminuq	(%rdi,%r9,8), %zmm27, %zmm27
	vmovdqu64	%zmm27, (%rdi,%r9,8) {%k1}
	addq	$8, %r9
	cmpq	%r9, %rsi
	jne	.LBB3_11
	leaq	1(%rax), %r9
	vmovdqa64	%zmm18, %zmm26
	vcvtsi2sd	%r9, %xmm5, %xmm23
	xorl	%r9d, %r9d
	vmulsd	%xmm23, %xmm5, %xmm24
	vaddsd	%xmm4, %xmm24, %xmm25
	vmulsd	%xmm23, %xmm3, %xmm24
	vmulsd	%xmm23, %xmm1, %xmm23
	vaddsd	%xmm2, %xmm24, %xmm24
	vaddsd	%xmm0, %xmm23, %xmm23
	vbroadcastsd	%xmm25, %zmm25
	vbroadcastsd	%xmm23, %zmm23
	vbroadcastsd	%xmm24, %zmm24
	.p2align	4
.LBB3_13:
	vpaddq	%zmm9, %zmm26, %zmm27
	vpaddq	%zmm22, %zmm26, %zmm26
	vpmovqd	%zmm27, %ymm27
	vcvtdq2pd	%ymm27, %zmm27
	vmulpd	%zmm27, %zmm6, %zmm28
	vmulpd	%zmm27, %zmm7, %zmm29
	vmulpd	%zmm27, %zmm8, %zmm27
	vaddpd	%zmm28, %zmm23, %zmm28
	vaddpd	%zmm29, %zmm24, %zmm29
	vaddpd	%zmm27, %zmm25, %zmm27
	vcmplepd	%zmm28, %zmm10, %k1
	vmulpd	%zmm28, %zmm13, %zmm28
	vcmplepd	%zmm29, %zmm11, %k1 {%k1}
	vmulpd	%zmm29, %zmm14, %zmm29
	vcmplepd	%zmm27, %zmm12, %k1 {%k1}
	vmulpd	%zmm27, %zmm15, %zmm27
	vaddpd	%zmm29, %zmm28, %zmm28
	vaddpd	%zmm28, %zmm27, %zmm27
	vdivpd	%zmm16, %zmm27, %zmm27
	vcvtpd2ps	%zmm27, %ymm28
	vcmpnltpd	%zmm19, %zmm27, %k2
	vcmpngtpd	%zmm20, %zmm27, %k3
	vpmovzxdq	%ymm28, %zmm27
	vmovdqa64	%zmm21, %zmm28
	vpsllq	$32, %zmm27, %zmm28 {%k3}
	vmovdqa64	%zmm17, %zmm27
	vporq	%zmm28, %zmm17, %zmm27 {%k2}
	vpminuq	(%r8,%r9,8), %zmm27, %zmm27
	vmovdqu64	%zmm27, (%r8,%r9,8) {%k1}
	addq	$8, %r9
	cmpq	%r9, %rsi
	jne	.LBB3_13
	addq	$2, %rax
	addq	%rcx, %rdi
	addq	%rcx, %r8
	subq	$2, %rdx
	jg	.LBB3_10
.LBB3_36:
	movq	128(%rsp), %rax
	movq	$0, (%rax)
	xorl	%eax, %eax
	addq	$136, %rsp
	.cfi_def_cfa_offset 56
	popq	%rbx
	.cfi_def_cfa_offset 48
	popq	%r12
	.cfi_def_cfa_offset 40
	popq	%r13
	.cfi_def_cfa_offset 32
	popq	%r14
	.cfi_def_cfa_offset 24
	popq	%r15
	.cfi_def_cfa_offset 16
	popq	%rbp
	.cfi_def_cfa_offset 8
	vzeroupper
	retq
.Lfunc_end3:
	.size	_ZN8__main__10draw_pieceB2v7B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i8UniTupleIxLi2EEx5ArrayIyLi1E1C7mutable7alignedExxx, .Lfunc_end3-_ZN8__main__10draw_pieceB2v7B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i8UniTupleIxLi2EEx5ArrayIyLi1E1C7mutable7alignedExxx
	.cfi_endproc

	.weak	NRT_decref
	.p2align	4
	.type	NRT_decref,@function
NRT_decref:
	.cfi_startproc
	testq	%rdi, %rdi
	je	.LBB4_2
	#MEMBARRIER
	lock		decq	(%rdi)
	je	.LBB4_3
.LBB4_2:
	retq
.LBB4_3:
	movabsq	$NRT_MemInfo_call_dtor, %rax
	#MEMBARRIER
	jmpq	*%rax
.Lfunc_end4:
	.size	NRT_decref, .Lfunc_end4-NRT_decref
	.cfi_endproc

	.weak	NRT_incref
	.p2align	4
	.type	NRT_incref,@function
NRT_incref:
	testq	%rdi, %rdi
	je	.LBB5_2
	lock		incq	(%rdi)
.LBB5_2:
	retq
.Lfunc_end5:
	.size	NRT_incref, .Lfunc_end5-NRT_incref

	.type	.const.draw_band,@object
	.section	.lrodata,"al",@progbits
.const.draw_band:
	.asciz	"draw_band"
	.size	.const.draw_band, 10

	.type	_ZN08NumbaEnv8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29,@object
	.comm	_ZN08NumbaEnv8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29,8,8
	.type	".const.missing Environment: _ZN08NumbaEnv8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29",@object
	.p2align	4, 0x0
".const.missing Environment: _ZN08NumbaEnv8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29":
	.asciz	"missing Environment: _ZN08NumbaEnv8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29"
	.size	".const.missing Environment: _ZN08NumbaEnv8__main__9draw_bandB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_2978Bins_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_298UniTupleIxLi2EEx119Target_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29", 578

	.type	".const.size mismatch for tuple, expected 6 element(s) but got %zd",@object
	.p2align	4, 0x0
".const.size mismatch for tuple, expected 6 element(s) but got %zd":
	.asciz	"size mismatch for tuple, expected 6 element(s) but got %zd"
	.size	".const.size mismatch for tuple, expected 6 element(s) but got %zd", 59

	.type	".const.can't unbox array from PyObject into native value.  The object maybe of a different type",@object
	.p2align	4, 0x0
".const.can't unbox array from PyObject into native value.  The object maybe of a different type":
	.asciz	"can't unbox array from PyObject into native value.  The object maybe of a different type"
	.size	".const.can't unbox array from PyObject into native value.  The object maybe of a different type", 89

	.type	".const.size mismatch for tuple, expected 2 element(s) but got %zd",@object
	.p2align	4, 0x0
".const.size mismatch for tuple, expected 2 element(s) but got %zd":
	.asciz	"size mismatch for tuple, expected 2 element(s) but got %zd"
	.size	".const.size mismatch for tuple, expected 2 element(s) but got %zd", 59

	.type	".const.size mismatch for tuple, expected 3 element(s) but got %zd",@object
	.p2align	4, 0x0
".const.size mismatch for tuple, expected 3 element(s) but got %zd":
	.asciz	"size mismatch for tuple, expected 3 element(s) but got %zd"
	.size	".const.size mismatch for tuple, expected 3 element(s) but got %zd", 59

	.type	".const.Error creating Python tuple from runtime exception arguments",@object
	.p2align	4, 0x0
".const.Error creating Python tuple from runtime exception arguments":
	.asciz	"Error creating Python tuple from runtime exception arguments"
	.size	".const.Error creating Python tuple from runtime exception arguments", 61

	.type	".const.unknown error when calling native function",@object
	.p2align	4, 0x0
".const.unknown error when calling native function":
	.asciz	"unknown error when calling native function"
	.size	".const.unknown error when calling native function", 43

	.type	".const.Error creating Python tuple from runtime exception arguments.1",@object
	.p2align	4, 0x0
".const.Error creating Python tuple from runtime exception arguments.1":
	.asciz	"Error creating Python tuple from runtime exception arguments"
	.size	".const.Error creating Python tuple from runtime exception arguments.1", 61

	.type	".const.unknown error when calling native function.2",@object
	.p2align	4, 0x0
".const.unknown error when calling native function.2":
	.asciz	"unknown error when calling native function"
	.size	".const.unknown error when calling native function.2", 43

	.type	".const.<numba.core.cpu.CPUContext>",@object
	.p2align	4, 0x0
".const.<numba.core.cpu.CPUContext>":
	.asciz	"<numba.core.cpu.CPUContext>"
	.size	".const.<numba.core.cpu.CPUContext>", 28

	.type	_ZN08NumbaEnv5numba2np8arrayobj12impl_np_full12_3clocals_3e4fullB2v3B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dExy17class_28uint64_29,@object
	.comm	_ZN08NumbaEnv5numba2np8arrayobj12impl_np_full12_3clocals_3e4fullB2v3B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dExy17class_28uint64_29,8,8
	.type	_ZN08NumbaEnv5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v4B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx17class_28uint64_29,@object
	.comm	_ZN08NumbaEnv5numba2np8arrayobj11ol_np_empty12_3clocals_3e4implB2v4B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dEx17class_28uint64_29,8,8
	.type	.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b,@object
	.p2align	4, 0x0
.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b:
	.ascii	"\200\004\225B\000\000\000\000\000\000\000\214\bbuiltins\224\214\nValueError\224\223\224\214\037negative dimensions not allowed\224\205\224N\207\224."
	.size	.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b, 77

	.type	.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1,@object
	.p2align	4, 0x0
.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1:
	.ascii	"3\033\205c\275\271\332\310\0338B\"s\005,Ho\301pk"
	.size	.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1, 20

	.type	.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b,@object
	.p2align	4, 0x0
.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b:
	.quad	.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b
	.long	77
	.zero	4
	.quad	.const.pickledata.331b8563bdb9dac81b38422273052c486fc1706b.sha1
	.quad	0
	.long	0
	.zero	4
	.size	.const.picklebuf.331b8563bdb9dac81b38422273052c486fc1706b, 40

	.type	.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57,@object
	.p2align	4, 0x0
.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57:
	.ascii	"\200\004\225~\000\000\000\000\000\000\000\214\bbuiltins\224\214\nValueError\224\223\224\214[array is too big; `arr.size * arr.dtype.itemsize` is larger than the maximum possible size.\224\205\224N\207\224."
	.size	.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57, 137

	.type	.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1,@object
	.p2align	4, 0x0
.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1:
	.ascii	"X\341N\314\265\007\261\340 i\201t\002#\346\205\313\214<W"
	.size	.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1, 20

	.type	.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57,@object
	.p2align	4, 0x0
.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57:
	.quad	.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57
	.long	137
	.zero	4
	.quad	.const.pickledata.58e14eccb507b1e0206981740223e685cb8c3c57.sha1
	.quad	0
	.long	0
	.zero	4
	.size	.const.picklebuf.58e14eccb507b1e0206981740223e685cb8c3c57, 40

	.type	_ZN08NumbaEnv5numba2np8arrayobj15_call_allocatorB2v5B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj,@object
	.comm	_ZN08NumbaEnv5numba2np8arrayobj15_call_allocatorB2v5B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj,8,8
	.type	_ZN08NumbaEnv5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v6B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj,@object
	.comm	_ZN08NumbaEnv5numba2np8arrayobj18_ol_array_allocate12_3clocals_3e4implB2v6B42c8tJTIeFIjxB2IKSgI4CrvQClcaMQ5hEEUSJJgA_3dEN29typeref_5b_3cclass_20_27numba4core5types8npytypes14Array_27_3e_5dExj,8,8
	.type	.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209,@object
	.p2align	4, 0x0
.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209:
	.ascii	"\200\004\225K\000\000\000\000\000\000\000\214\bbuiltins\224\214\013MemoryError\224\223\224\214'Allocation failed (probably too large).\224\205\224N\207\224."
	.size	.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209, 86

	.type	.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1,@object
	.p2align	4, 0x0
.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1:
	.ascii	"\272(\235\201\360\\p \363G|\025sH\004\337e\253\342\t"
	.size	.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1, 20

	.type	.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209,@object
	.p2align	4, 0x0
.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209:
	.quad	.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209
	.long	86
	.zero	4
	.quad	.const.pickledata.ba289d81f05c7020f3477c15734804df65abe209.sha1
	.quad	0
	.long	0
	.zero	4
	.size	.const.picklebuf.ba289d81f05c7020f3477c15734804df65abe209, 40

	.type	_ZN08NumbaEnv8__main__10draw_pieceB2v7B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i8UniTupleIxLi2EEx5ArrayIyLi1E1C7mutable7alignedExxx,@object
	.comm	_ZN08NumbaEnv8__main__10draw_pieceB2v7B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i8UniTupleIxLi2EEx5ArrayIyLi1E1C7mutable7alignedExxx,8,8
	.type	_ZN08NumbaEnv8__main__7sampledB2v8B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i23Literal_5bint_5d_280_29xx,@object
	.comm	_ZN08NumbaEnv8__main__7sampledB2v8B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i23Literal_5bint_5d_280_29xx,8,8
	.type	_ZN08NumbaEnv8__main__7sampledB3v12B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i23Literal_5bint_5d_281_29xx,@object
	.comm	_ZN08NumbaEnv8__main__7sampledB3v12B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i23Literal_5bint_5d_281_29xx,8,8
	.type	_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB2v9B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi3EE,@object
	.comm	_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB2v9B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi3EE,8,8
	.type	_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v11B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi3EE,@object
	.comm	_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v11B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi3EE,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster8coverage5edgesB3v30B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29ix,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster8coverage5edgesB3v30B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29ix,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster8coverage8positionB3v17B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE5ArrayIiLi2E1C7mutable7alignedEi,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster8coverage8positionB3v17B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE5ArrayIiLi2E1C7mutable7alignedEi,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster8coverage10twice_areaB3v18B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE8UniTupleIxLi2EE8UniTupleIxLi2EE8UniTupleIxLi2EE,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster8coverage10twice_areaB3v18B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE8UniTupleIxLi2EE8UniTupleIxLi2EE8UniTupleIxLi2EE,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster8coverage13edge_functionB3v31B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE8UniTupleIxLi2EE8UniTupleIxLi2EExx,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster8coverage13edge_functionB3v31B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE8UniTupleIxLi2EE8UniTupleIxLi2EExx,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster8coverage10acceptanceB3v32B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE33EdgeFunction_28float64_20x_203_29,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster8coverage10acceptanceB3v32B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE33EdgeFunction_28float64_20x_203_29,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster8coverage16owns_its_samplesB3v33B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE33EdgeFunction_28float64_20x_203_29,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster8coverage16owns_its_samplesB3v33B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE33EdgeFunction_28float64_20x_203_29,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster9rasterize6depthsB3v34B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster9rasterize6depthsB3v34B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE238Primitives_28array_28int32_2c_202d_2c_20C_29_2c_20array_28int32_2c_201d_2c_20C_29_2c_20array_28int32_2c_202d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_201d_2c_20C_29_2c_20array_28float32_2c_202d_2c_20C_29_29i,8,8
	.type	_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi2EE,@object
	.comm	_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi2EE,8,8
	.type	_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB2v2B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi2EE,@object
	.comm	_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB2v2B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIxLi2EE,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster8coverage15covered_columnsB3v35B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE8UniTupleI33EdgeFunction_28float64_20x_203_29Li3EExxx,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster8coverage15covered_columnsB3v35B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE8UniTupleI33EdgeFunction_28float64_20x_203_29Li3EExxx,8,8
	.type	_ZN08NumbaEnv7sss_ref6raster8coverage16accepted_columnsB3v36B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE33EdgeFunction_28float64_20x_203_29xdd,@object
	.comm	_ZN08NumbaEnv7sss_ref6raster8coverage16accepted_columnsB3v36B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE33EdgeFunction_28float64_20x_203_29xdd,8,8
	.type	_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v37B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIdLi2EE,@object
	.comm	_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB3v37B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIdLi2EE,8,8
	.type	_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB3v38B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIdLi2EE,@object
	.comm	_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB3v38B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWqFpgsIBZmgA_3dE15StarArgUniTupleIdLi2EE,8,8
	.type	_ZN08NumbaEnv8__main__8draw_rowB3v13B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE5ArrayIyLi1E1C7mutable7alignedEx8UniTupleIxLi2EE5TupleI8UniTupleIdLi3EE8UniTupleIdLi3EE8UniTupleIdLi3EE8UniTupleIdLi3EEdEy,@object
	.comm	_ZN08NumbaEnv8__main__8draw_rowB3v13B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAK4JJIqUWsIgmAA_3d_3dE5ArrayIyLi1E1C7mutable7alignedEx8UniTupleIxLi2EE5TupleI8UniTupleIdLi3EE8UniTupleIdLi3EE8UniTupleIdLi3EE8UniTupleIdLi3EEdEy,8,8
	.section	".note.GNU-stack","",@progbits
